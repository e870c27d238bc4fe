# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the check of discovery messages takes and refuses."""
import json
import unittest

from home_assistant import Entity, complaints

SENSOR = "homeassistant/sensor/hall_g1_line1_meter/voltage/config"
NUMBER = "homeassistant/number/hall_g1_line1_meter/set_point/config"


def a_sensor(**changes):
    said = {"name": "voltage", "unique_id": "u1", "state_topic": "a/state", "value_template": "{{ value_json['values']['x']['value'] }}",
            "device_class": "voltage", "state_class": "measurement", "unit_of_measurement": "V", "expire_after": 5,
            "availability": [{"topic": "a/status"}], "availability_mode": "all",
            "device": {"identifiers": ["i"], "name": "meter"}, "origin": {"name": "rtuwire"}}
    said.update(changes)
    return json.dumps({key: value for key, value in said.items() if value is not None})


def a_number(**changes):
    said = json.loads(a_sensor(device_class=None, state_class=None, expire_after=None, unit_of_measurement=None))
    said.update({"command_topic": "a/set", "command_template": '{"value": {{ value }}}', "min": 5, "max": 60, "step": 0.1, "mode": "box",
                 "optimistic": False, "retain": False, "entity_category": "config"})
    said.update(changes)
    return json.dumps({key: value for key, value in said.items() if value is not None})


class Refused(unittest.TestCase):
    def test_right_ones(self):
        self.assertEqual(complaints(SENSOR, a_sensor()), [])
        self.assertEqual(complaints(NUMBER, a_number()), [])
        self.assertEqual(complaints(SENSOR, a_sensor(device_class="energy", unit_of_measurement="kWh", state_class="total_increasing")), [])
        self.assertEqual(complaints(SENSOR, a_sensor(device_class="enum", options=["off", "heat"], unit_of_measurement=None,
                                                     state_class=None)), [])

    def test_topics(self):
        for topic in ("homeassistant/sensor/a.b/voltage/config", "other/sensor/a/voltage/config", "homeassistant/sensor/a/b/c/config",
                      "homeassistant/sensors/a/voltage/config", "homeassistant/sensor/a/voltage/conf"):
            self.assertTrue(complaints(topic, a_sensor()), topic)

    def test_sensors(self):
        for changes in (dict(unit_of_measurement="degC", device_class="temperature"), dict(unit_of_measurement="KWh", device_class="energy"),
                        dict(device_class="energy", unit_of_measurement="kWh"), dict(device_class="volts"), dict(state_class="total"),
                        dict(state_class="increasing"), dict(expires_after=5), dict(expire_after="5"), dict(expire_after=5.5),
                        dict(expire_after=True), dict(state_topic="a/#"), dict(state_topic=None), dict(unique_id=None),
                        dict(device={"name": "meter"}), dict(device={"identifiers": ["i"], "vendor": "x"}), dict(availability_mode="every"),
                        dict(availability=["a/status"]), dict(availability=[{"topic": "+"}]), dict(availability_topic="a/b"),
                        dict(entity_category="config"), dict(options=["a"]), dict(device_class="enum"), dict(qos=3),
                        dict(value_template="{{ value_json.x "), dict(origin={"sw_version": "1"}),
                        dict(last_reset_value_template="{{ 1 }}")):
            self.assertTrue(complaints(SENSOR, a_sensor(**changes)), changes)
        for payload in ("", "{", "[]", '"x"'):
            self.assertTrue(complaints(SENSOR, payload), payload)

    def test_numbers(self):
        for changes in (dict(command_topic=None), dict(min=60), dict(min=61), dict(step=0.0001), dict(mode="field"), dict(min="5"),
                        dict(device_class="temperature", unit_of_measurement="degC"), dict(retain="no"), dict(state_class="measurement")):
            self.assertTrue(complaints(NUMBER, a_number(**changes)), changes)

    def test_templates(self):
        entity = Entity(SENSOR, a_sensor())
        self.assertEqual(entity.state('{"values": {"x": {"value": 230.5}}}'), "230.5")
        self.assertIsNone(entity.state('{"values": {"x": {"value": null}}}'))
        self.assertTrue(entity.fits("230.5") and entity.fits(None) and not entity.fits("on") and not entity.fits("nan"))
        with self.assertRaises(Exception):
            entity.state('{"values": {}}')
        # A table has functions, and one is called `values`.
        with self.assertRaises(Exception):
            Entity(SENSOR, a_sensor(value_template="{{ value_json.values.x.value }}")).state('{"values": {"x": {"value": 1}}}')
        self.assertEqual(Entity(NUMBER, a_number()).command(21.5), '{"value": 21.5}')
        self.assertFalse(Entity(SENSOR, a_sensor(device_class="enum", options=["off"])).fits("on"))


if __name__ == "__main__":
    unittest.main()
