// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Macros that users' other headers define, as they define them (with arguments or without), each with a text that no
// C++ compiler accepts. What the standard library says of them is not asked: its headers come first.
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ratio>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#ifdef __PCLMUL__
#include <wmmintrin.h>
#endif

// Arduino's `word` is the only one that the headers meet, and is as Arduino has it: `value.word()` gets another name,
// everywhere the same.
#define word(...) makeWord(__VA_ARGS__)

// Letters, as programs in C define them; R and T are the names of what a template takes, and F is Arduino's, below.
#define A @
#define B @
#define C @
#define D @
#define E @
#define G @
#define H @
#define I @
#define J @
#define K @
#define L @
#define M @
#define N @
#define O @
#define P @
#define Q @
#define S @
#define U @
#define V @
#define W @
#define X @
#define Y @
#define Z @

// Qt (qobjectdefs.h, qtmetamacros.h, qglobal.h, qforeach.h).
#define foreach(a, b) @
#define SIGNAL(a) @
#define SLOT(a) @
#define METHOD(a) @
#define slots @
#define signals @
#define emit @
#define forever @
#define Q_SLOTS @
#define Q_SIGNALS @
#define Q_EMIT @
#define Q_OBJECT @

// Arduino (Arduino.h of the cores for AVR, SAMD, ESP32, STM32).
#define min(a, b) @
#define max(a, b) @
#define abs(x) @
#define round(x) @
#define constrain(x, low, high) @
#define radians(x) @
#define degrees(x) @
#define sq(x) @
#define bit(b) @
#define bitRead(x, b) @
#define bitSet(x, b) @
#define bitClear(x, b) @
#define bitToggle(x, b) @
#define bitWrite(x, b, y) @
#define lowByte(w) @
#define highByte(w) @
#define F(s) @
#define interrupts() @
#define noInterrupts() @
#define digitalPinToPort(p) @
#define analogInPinToBit(p) @
#define clockCyclesToMicroseconds(a) @
#define microsecondsToClockCycles(a) @
#define isnan(x) @
#define _BV(b) @
#define cbi(a, b) @
#define sbi(a, b) @
#define PSTR(s) @
#define PGM_P(s) @
#define pgm_read_byte(a) @
#define pgm_read_word(a) @
#define sei() @
#define cli() @
#define ISR(v) @
#define EMPTY_INTERRUPT(v) @
#define bit_is_set(a, b) @
#define bit_is_clear(a, b) @
#define loop_until_bit_is_set(a, b) @
#define HIGH @
#define LOW @
#define INPUT @
#define OUTPUT @
#define INPUT_PULLUP @
#define CHANGE @
#define FALLING @
#define RISING @
#define PI @
#define HALF_PI @
#define TWO_PI @
#define EULER @
#define DEG_TO_RAD @
#define RAD_TO_DEG @
#define SERIAL @
#define DISPLAY @
#define LSBFIRST @
#define MSBFIRST @
#define DEFAULT @
#define EXTERNAL @
#define INTERNAL @
#define INTERNAL1V1 @
#define DEC @
#define HEX @
#define OCT @
#define BIN @
#define LED_BUILTIN @
#define SS @
#define MOSI @
#define MISO @
#define SCK @
#define SDA @
#define SCL @
#define A0 @
#define A1 @
#define A2 @
#define A3 @
#define NOT_A_PIN @
#define NOT_A_PORT @
#define NOT_ON_TIMER @
#define B0 @
#define B1 @
#define B00 @
#define B01 @
#define B10 @
#define B11 @
#define B000 @
#define B101 @
#define B0000 @
#define B1010 @
#define B00000000 @
#define B11111111 @
#define Serial @
#define Serial1 @
#define PROGMEM @
#define SP @
#define SPL @
#define SPH @
#define SREG @
#define PORTA @
#define PORTB @
#define PORTC @
#define DDRA @
#define DDRB @
#define DDRC @
#define PINA @
#define PINB @
#define PINC @
#define UDR0 @
#define UBRR0 @
#define UCSR0A @
#define TCNT0 @
#define TCCR0A @
#define OCR0A @
#define ADC @
#define ADCL @
#define ADMUX @
#define WDTCSR @
#define MCUSR @
#define EEAR @
#define RXC0 @
#define TXC0 @
#define PB0 @
#define PD1 @
#define PE @
#define FE @
#define OR0 @
#define RAMEND @
#define F_CPU @
#define SIG_UART_DATA @

// CMSIS and the libraries on it (core_cm*.h, stm32*.h, nrf*.h), ESP-IDF, Zephyr.
#define SET_BIT(r, b) @
#define CLEAR_BIT(r, b) @
#define READ_BIT(r, b) @
#define CLEAR_REG(r) @
#define WRITE_REG(r, v) @
#define READ_REG(r) @
#define MODIFY_REG(r, c, s) @
#define UNUSED(x) @
#define assert_param(x) @
#define POSITION_VAL(x) @
#define IS_FUNCTIONAL_STATE(x) @
#define _VAL2FLD(f, v) @
#define _FLD2VAL(f, v) @
#define MIN(a, b) @
#define MAX(a, b) @
#define ABS(a) @
#define BIT(n) @
#define BIT_MASK(n) @
#define GENMASK(h, l) @
#define CLAMP(a, b, c) @
#define ARRAY_SIZE(a) @
#define CONTAINER_OF(a, b, c) @
#define ROUND_UP(a, b) @
#define CONCAT(a, b) @
#define STRINGIFY(a) @
#define likely(x) @
#define unlikely(x) @
#define __I @
#define __O @
#define __IO @
#define __IM @
#define __OM @
#define __IOM @
#define __ASM @
#define __INLINE @
#define __STATIC_INLINE @
#define __weak @
#define __NO_RETURN @
#define __PACKED @
#define SCB @
#define NVIC @
#define SysTick @
#define MPU @
#define FPU @
#define ITM @
#define DWT @
#define CRC @
#define DMA1 @
#define DMA2 @
#define USART1 @
#define USART2 @
#define UART4 @
#define RTC @
#define PWR @
#define RCC @
#define GPIOA @
#define GPIOB @
#define GPIO @
#define TIM1 @
#define TIM2 @
#define SPI1 @
#define I2C1 @
#define ADC1 @
#define CAN @
#define CAN1 @
#define DAC @
#define COMP @
#define EXTI @
#define FLASH @
#define IWDG @
#define WWDG @
#define RNG @
#define USB @
#define SYSCFG @
#define DBGMCU @
#define OPAMP @
#define TSC @
#define CRS @
#define TIMER0 @
#define UART0 @
#define NRF_UART0 @
#define NRF_TIMER0 @
#define PORT @
#define SERCOM0 @
#define WDT @
#define PM @
#define TC3 @
#define EIC @
#define MCLK @
#define USE_FULL_ASSERT @
#define HSE_VALUE @
#define HSI_VALUE @
#define UNIT_TEST @
#define VDD_VALUE @
#define BIT0 @
#define BIT1 @
#define BIT2 @
#define BIT7 @
#define BIT15 @
#define BIT31 @
#define BIT_0 @
#define portMAX_DELAY @
#define pdTRUE @
#define pdFALSE @
#define pdPASS @
#define pdFAIL @
#define tskNO_AFFINITY @
#define TAG @
#define CONFIG @
#define IRAM_ATTR @
#define DRAM_ATTR @

// Windows (windef.h, winnt.h, rpcndr.h, winerror.h, wingdi.h, winuser.h).
#define TEXT(s) @
#define MAKEWORD(a, b) @
#define LOWORD(a) @
#define HIWORD(a) @
#define LOBYTE(a) @
#define HIBYTE(a) @
#define RGB(r, g, b) @
#define Yield() @
#define GetCurrentTime() @
#define FAILED(a) @
#define SUCCEEDED(a) @
#define near @
#define far @
#define NEAR @
#define FAR @
#define IN @
#define OUT @
#define OPTIONAL @
#define CONST @
#define VOID @
#define TRUE @
#define FALSE @
#define small @
#define hyper @
#define interface @
#define cdecl @
#define pascal @
#define CALLBACK @
#define WINAPI @
#define APIENTRY @
#define THIS @
#define THIS_ @
#define PURE @
#define STRICT @
#define UNICODE @
#define ERROR @
#define NO_ERROR @
#define NOERROR @
#define DELETE @
#define READ_CONTROL @
#define SYNCHRONIZE @
#define S_OK @
#define S_FALSE @
#define INFINITE @
#define STATUS_TIMEOUT @
#define STATUS_PENDING @
#define WAIT_TIMEOUT @
#define ERROR_TIMEOUT @
#define IGNORE @
#define ABSOLUTE @
#define RELATIVE @
#define OPAQUE @
#define TRANSPARENT @
#define ALTERNATE @
#define PASSTHROUGH @
#define EVENPARITY @
#define ODDPARITY @
#define NOPARITY @
#define ONESTOPBIT @
#define TWOSTOPBITS @
#define CBR_19200 @
#define DTR_CONTROL_ENABLE @
#define SETRTS @
#define CLRRTS @
#define EV_RXCHAR @
#define EV_BREAK @
#define CE_FRAME @
#define CE_RXPARITY @
#define DOMAIN @
#define OVERFLOW @
#define UNDERFLOW @
#define GetMessage @
#define SendMessage @
#define PostMessage @
#define CreateFile @
#define GetObject @
#define GetClassName @
#define DrawText @
#define LoadString @
#define MessageBox @
#define RegisterClass @

// POSIX and X11, which a program on a host may have included before.
#define major @
#define minor @
#define makedev @
#undef unix
#define unix @
#undef linux
#define linux @
#define None @
#define Bool @
#define Status @
#define True @
#define False @
#define Success @
#define Always @
#define Above @
#define Below @
#define Expose @
#define KeyPress @
#define ECHO @
#define CR0 @
#define TAB0 @
#define NL0 @
