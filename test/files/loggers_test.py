# SPDX-License-Identifier: MIT
"""Binary logs of flight computers and autopilots, written here byte by byte from their published layouts."""
import json
import struct

import numpy
import pytest
from conftest import read_bytes
from fantail_files import files

G = 9.80665
# The example of the data sheet of the MS5607-02BA03 (TE Connectivity, 2017): 20 degC and 1100.02 hPa.
BAROMETER = {"sens": 46372, "off": 43981, "tcs": 29059, "tco": 27842, "tref": 31553, "tempsens": 28165}
RAW_PRESSURE, RAW_TEMPERATURE, PRESSURE_PA = 6465444, 8077636, 110002


def sealed(record):
    """With the byte that makes the sum of all and 0x5A a multiple of 256."""
    record = bytearray(record)
    record[1] = -(0x5A + sum(record)) & 0xFF
    return bytes(record)


def mega_flight(tick):
    """Ground: 1000 counts of the high-g accelerometer, PRESSURE_PA, a roll gyro that reads 10 at rest."""
    return sealed(struct.pack("<cBHHhi3hxx3i", b"F", 0, tick, 7, 1000, PRESSURE_PA, 0, 0, 0, 10 * 512, 0, 0))


def mega_sample(tick, accel, forces=(1365, 0, 0), rates=(10, 0, 0)):
    return sealed(struct.pack("<cBHII9hh", b"A", 0, tick, RAW_PRESSURE, RAW_TEMPERATURE, *forces, *rates, 0, 0, 0, accel))


def image(records, **settings):
    about = {"log_format": 22, "serial": 4711, "flight": 7, "accel_cal_plus": 1100, "accel_cal_minus": 900, "accel_zero_along": 0,
             "accel_zero_across": 0, "accel_zero_through": 0, "ms5607": BAROMETER, "callsign": "N0CALL", "main_deploy": 2147483647}
    lines = [record.hex(" ") for record in records]
    return (json.dumps(about | settings) + "\n" + "\n".join(lines) + "\n").encode()


def test_a_flash_image_of_a_telemega_has_the_columns_of_the_export_of_altosui():
    # The counter wraps between the samples; the first was taken 0.3 s before the flight's record.
    records = [mega_flight(65530), mega_sample(65500, 1000), mega_sample(65530, 1500, rates=(10 + 16384, 0, 0)), mega_sample(4, 900),
               b"\xff" * 32]
    table = read_bytes(image(records), ".eeprom")
    assert table["time"] == pytest.approx([-0.30, 0.0, 0.10])
    # Half of the way from +1 g to -1 g is 100 counts.
    assert table["acceleration"] == pytest.approx([0.0, 5 * G, -G])
    assert table["accel_x"] == pytest.approx([G, G, G])  # 1365 counts a g, gravity included
    assert table["gyro_roll"] == pytest.approx([0.0, 1000.0, 0.0], abs=0.1)  # 32767 counts are 2000 deg/s
    assert table["pressure"] == pytest.approx([PRESSURE_PA] * 3, abs=1.0)
    assert table["height"] == pytest.approx([0.0] * 3, abs=0.1)
    assert set(table["serial"]) == {4711} and set(table["call"]) == {"N0CALL"} and not table.notes


def test_a_damaged_record_of_a_flash_image_is_left_out_and_said():
    broken = bytearray(mega_sample(20, 1000))
    broken[12] ^= 1
    table = read_bytes(image([mega_flight(0), mega_sample(10, 1000), bytes(broken)]), ".eeprom")
    assert len(table) == 1
    assert table.notes == ["Damaged records, which are left out: 1."]


def test_an_image_that_is_cut_off_in_a_byte_is_read_up_to_there():
    table = read_bytes(image([mega_flight(0), mega_sample(10, 1000), mega_sample(20, 1000)])[:-2], ".eeprom")
    assert len(table) == 1


def test_a_computer_without_accelerometer_has_no_acceleration_and_none_is_made_up():
    pressure, temperature = RAW_PRESSURE.to_bytes(3, "little"), RAW_TEMPERATURE.to_bytes(3, "little")
    flight = sealed(struct.pack("<cBHHxxi4x", b"F", 0, 0, 3, PRESSURE_PA))
    sample = sealed(struct.pack("<cBH", b"A", 0, 5) + pressure + temperature + bytes(6))
    table = read_bytes(image([flight, sample], log_format=14), ".eeprom")
    assert list(table.columns) == ["version", "serial", "flight", "time", "pressure", "height"]


@pytest.mark.parametrize("content, said", [
    (image([], log_format=22), "holds no flight"), (image([mega_flight(0), mega_sample(1, 0)], log_format=99), "log format 99"),
    (image([mega_flight(0), mega_sample(1, 0)], ms5607={}), "calibration of its barometer"),
    (image([mega_flight(0), mega_sample(1, 0)], accel_cal_minus=1100), "calibration of its accelerometer"),
    (b"{\"log_format\": 22}\nzz zz", "is damaged"), (b"{", "is damaged"), (b"", "is not the flash image"),
    (b"PerfectFlite SL100\nData: (Time, Altitude)\n0,1\n", "is not the flash image"),
    (image([b"A" + bytes(31)]), "damaged records: 1")])
def test_an_image_that_holds_no_flight_is_refused_with_the_reason(content, said):
    with pytest.raises(files.BadFile, match=said):
        read_bytes(content, ".eeprom")


def packet(tick, acceleration, speed, height, status=0x80, serial=99):
    """What a TeleMega computes of itself: sixteenths of m/s2 and m/s, metres."""
    content = struct.pack("<HHB21xhhh2x", serial, tick, 0x09, int(16 * acceleration), int(16 * speed), height)
    content = bytes([34]) + content[:32] + bytes([40, status])
    return b"TELEM " + (content + bytes([(0x5A + sum(content[1:])) & 0xFF])).hex().encode() + b"\n"


def test_packets_of_a_flight_computer_are_read_and_those_that_the_radio_doubts_left_out():
    content = packet(100, 0.5, 0.0, 0) + packet(110, 98.0, 9.5, 1) + packet(115, 1.0, 1.0, 1, status=0) + b"TELEM 22ff\n" + \
        packet(120, 40.0, 20.0, 3) + packet(9, 0.0, 0.0, 0, serial=5)
    table = read_bytes(content, ".telem")
    assert table["time"] == pytest.approx([0.0, 0.1, 0.2])
    assert table["acceleration"] == pytest.approx([0.5, 98.0, 40.0])
    assert table["speed"] == pytest.approx([0.0, 9.5, 20.0])
    assert table["height"] == pytest.approx([0, 1, 3])
    assert table.notes == ["Damaged packets, which are left out: 2 of 6.",
                           "The file has packets of 2 computers; those of number 99, which are most, are read."]


def dataflash(messages):
    """FMT, then IMU and BARO as ArduPilot lays them out."""
    formats = [(0x80, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns"), (0x81, 3 + 8 + 1 + 24, b"IMU", b"QBffffff",
               b"TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"), (0x82, 3 + 8 + 4, b"BARO", b"Qf", b"TimeUS,Alt")]
    out = b"".join(struct.pack("<3BBB4s16s64s", 0xA3, 0x95, 0x80, *one) for one in formats)
    for kind, *values in messages:
        out += struct.pack("<3B", 0xA3, 0x95, {"IMU": 0x81, "BARO": 0x82}[kind])
        out += struct.pack("<QB6f" if kind == "IMU" else "<Qf", *values)
    return out


def test_a_dataflash_log_has_the_first_imu_and_the_barometer_in_order_of_time():
    table = read_bytes(dataflash([("IMU", 1000, 0, 0.5, 0.0, 0.0, 9.75, 0.25, 0.0), ("IMU", 1000, 1, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0),
                                  ("BARO", 1500, 12.5), ("IMU", 2000, 0, 0.75, 0.0, 0.0, 19.5, 0.25, 0.0)]), ".BIN")
    assert list(table["TimeUS"]) == [1000, 1500, 2000]
    assert table["IMU.AccX"] == pytest.approx([9.75, numpy.nan, 19.5], nan_ok=True)
    assert table["IMU.GyrX"] == pytest.approx([0.5, numpy.nan, 0.75], nan_ok=True)
    assert table["BARO.Alt"] == pytest.approx([numpy.nan, 12.5, numpy.nan], nan_ok=True)


def test_a_dataflash_log_without_an_imu_is_refused_with_what_it_has():
    with pytest.raises(files.BadFile, match="no message IMU; it has: BARO FMT"):
        read_bytes(dataflash([("BARO", 1500, 12.5)]), ".bin")


def variable(value):
    """A signed number in sevens of bits: zigzag, then the lowest first."""
    value = value << 1 if value >= 0 else -value * 2 - 1
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*out, value])


def black_box(frames, gyro_scale=0x3F800000, extra=""):
    names = "loopIteration,time," + ",".join(f"{what}[{i}]" for what in ("gyroADC", "accSmooth") for i in range(3))
    head = ("H Product:Blackbox flight data recorder by Nicholas Sherlock\nH Data version:2\nH I interval:1\nH P interval:1\n"
            f"H Field I name:{names}\nH Field I signed:0,0,1,1,1,1,1,1\nH Field I predictor:0,0,0,0,0,0,0,0\n"
            f"H Field I encoding:0,0,0,0,0,0,0,0\nH Field P predictor:6,2,1,1,1,1,1,1\nH Field P encoding:9,0,0,0,0,0,0,0\n"
            f"H gyro_scale:0x{gyro_scale:x}\nH acc_1G:2048\n{extra}")
    return head.encode() + b"".join(b"I" + b"".join(map(variable, frame)) for frame in frames) + b"E\xffEnd of log\0"


def test_a_black_box_of_betaflight_has_rates_in_degrees_and_forces_in_g():
    table = read_bytes(black_box([(0, 1000, 5, 0, 0, 2048, 0, 0), (1, 2000, -360, 1, 2, 20480, -1024, 0)]), ".bbl")
    assert list(table["time"]) == [1000, 2000]
    assert table["gyroADC[0]"] == pytest.approx([5, -360])
    assert table["accSmooth[0]"] == pytest.approx([1.0, 10.0])
    assert table["accSmooth[1]"] == pytest.approx([0.0, -0.5])


def test_of_several_logs_in_a_black_box_the_longest_is_read_and_rates_of_an_unknown_size_are_not():
    short = black_box([(0, 1, 0, 0, 0, 0, 0, 0)])
    table = read_bytes(short + black_box([(i, 1000 * i + 1000, 7, 0, 0, 2048, 0, 0) for i in range(9)], gyro_scale=0x3F000000), ".bfl")
    assert len(table) == 9
    assert "gyroADC[0]" not in table.columns
    assert table.notes == ["The file holds 2 logs; the longest, number 2, is read.",
                           "Its rates are in counts of an unknown size (gyro_scale is not 1); they are left out."]


def test_a_black_box_that_is_cut_off_is_read_up_to_there():
    whole = black_box([(i, 1000 * i + 1000, 7, 0, 0, 2048, 0, 0) for i in range(50)])
    cut = read_bytes(whole[:whole.index(b"E\xffEnd of log") - 3], ".bbl")
    assert 40 < len(cut) < 51


@pytest.mark.parametrize("ending", [".bin", ".bbl", ".bfl"])
def test_what_is_no_log_of_an_autopilot_is_refused(ending):
    with pytest.raises(files.BadFile, match="is not a"):
        read_bytes(b"time,axial\n1,2\n", ending)
