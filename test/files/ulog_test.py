# SPDX-License-Identifier: MIT
"""ULogs of PX4: what is read of a sound one and of one that is damaged."""
import collections
import random
import struct

import pytest
from conftest import read_bytes
from fantail_files import files


def message(kind, content):
    return struct.pack("<H", len(content)) + kind.encode() + content


SYNC = message("S", b"\x2F\x73\x13\x20\x25\x0C\xBB\x12")
HEAD = (b"ULog\x01\x12\x35\x01" + struct.pack("<Q", 1_000_000) + message("B", bytes(40)) +
        message("F", b"sensor_combined:uint64_t timestamp;float[3] gyro_rad;float[3] accelerometer_m_s2;") +
        message("F", b"vehicle_air_data:uint64_t timestamp;uint32_t baro_device_id;float baro_alt_meter;uint8_t[4] _padding0;") +
        message("F", b"cpuload:uint64_t timestamp;float load;") +
        b"".join(message("A", struct.pack("<BH", instance, number) + topic)
                 for instance, number, topic in [(0, 7, b"sensor_combined"), (1, 8, b"sensor_combined"), (0, 9, b"vehicle_air_data"),
                                                 (0, 11, b"cpuload")]))


def motion(time_us, axial):
    return message("D", struct.pack("<HQ6f", 7, time_us, 0.1, 0.2, 0.3, axial, 0.0, -1.0))


def air(time_us, height):
    return message("D", struct.pack("<HQIf", 9, time_us, 12, height))


def whole():
    content = HEAD
    for i in range(20):
        content += motion(1_000_000 + 4000 * i, 9.5 + i)
        if i % 5 == 0:
            content += air(1_000_500 + 4000 * i, 100.0 + i)
            content += message("D", struct.pack("<HQ6f", 8, 1_000_000 + 4000 * i, *[50.0] * 6))  # a second instance
            content += message("D", struct.pack("<HQf", 11, 1_000_000 + 4000 * i, 0.5)) + SYNC
    return content + message("O", struct.pack("<H", 25))


def read(content):
    return read_bytes(content, ".ulg")


def rows(table):
    """A damaged file may lose some of them."""
    names = ("timestamp", "gyro_rad[0]", "accelerometer_m_s2[0]", "accelerometer_m_s2[2]")
    return collections.Counter(tuple(map(str, row)) for row in zip(*(table[name].tolist() for name in names)))


def test_there_is_a_row_for_each_message_of_the_two_topics_in_order_of_time():
    table = read(whole())
    time, axial, height = table["timestamp"], table["accelerometer_m_s2[0]"], table["baro_alt_meter"]
    assert len(table) == 24 and (time[1:] >= time[:-1]).all()
    assert (time[1], height[1], str(axial[1])) == (1_000_500, 100.0, "nan")
    assert (time[2], axial[2], str(height[2])) == (1_004_000, 10.5, "nan")
    assert abs(table["gyro_rad[2]"][2] - 0.3) < 1e-7
    assert (table["accelerometer_m_s2[2]"][2], table["baro_device_id"][1]) == (-1.0, 12.0)
    assert table.notes == ["The logger reports that it dropped 25 ms."]


def test_without_the_topic_those_that_are_there_are_named():
    with pytest.raises(files.BadFile, match="no message of the topic sensor_combined; its topics are: cpuload"):
        read(HEAD + message("D", struct.pack("<HQf", 11, 1_000_000, 0.5)))
    with pytest.raises(files.BadFile, match="is not a ULog; it begins with 'time_s,'"):
        read(b"time_s,a\n")


def test_cut_off_anywhere_it_has_the_rows_up_to_there():
    content = whole()
    every_row = rows(read(content))
    read_at_all = 0
    for size in range(len(content)):
        try:
            table = read(content[:size])
        except files.BadFile:
            continue
        read_at_all += 1
        assert rows(table) <= every_row, size
        ends_in_a_message = not any(content[:size].endswith(part) for part in (SYNC, table_end(content, size)))
        assert not ends_in_a_message or any("cut off" in note for note in table.notes), size
    assert read_at_all > len(content) / 2


def table_end(content, size):
    """The last whole message in front of a place, if the place is its end."""
    at = 16
    while at + 3 <= size:
        end = at + 3 + struct.unpack_from("<H", content, at)[0]
        if end == size:
            return content[at:end]
        at = end
    return b"\0" * (size + 1)


def test_with_any_bit_flipped_it_is_read_or_refused():
    content = whole()
    read_at_all = 0
    for bit in range(8 * len(content)):
        flipped = bytearray(content)
        flipped[bit // 8] ^= 1 << bit % 8
        try:
            assert len(read(bytes(flipped))) <= 24 + 5, bit
            read_at_all += 1
        except files.BadFile:
            pass
    assert read_at_all > 4 * len(content), "most bits are one figure of one row"


def test_of_any_bytes_it_is_a_table_or_a_refusal():
    drawn = random.Random(1)
    for _ in range(500):
        content = bytearray(whole())
        for _ in range(drawn.randrange(1, 20)):
            content[drawn.randrange(len(content))] = drawn.randrange(256)
        try:
            read(bytes(content))
        except files.BadFile:
            pass


def test_behind_damage_it_is_read_on_from_the_next_sync_message():
    content = whole()
    there = motion(1_004_000, 10.5)
    table = read(content.replace(there, b"\xFF\xFF\xFF" + there[3:]))
    assert any("damaged" in note or "cut off" in note for note in table.notes)
    assert rows(table) <= rows(read(content))


def test_a_message_that_stands_alone_with_its_time_is_left_out():
    more = b"".join(motion(1_100_000 + 4000 * i, 9.5) for i in range(100))
    for time_us in (1_060_000, 1_000_100, 4_000_000_000):
        table = read(whole().replace(motion(1_036_000, 18.5), motion(time_us, 18.5)) + more)
        assert len(table) == 24 - 1 + 100, time_us
        assert table.notes[0] == "One message that stands alone with its time is left out."


def test_time_that_goes_back_is_refused():
    back = b"".join(motion(1_050_000 + 4000 * i, 9.5) for i in range(10))
    with pytest.raises(files.BadFile, match="topic sensor_combined: from 1.076000 s to 1.050000 s"):
        read(whole() + back)
    often = b"".join(motion(1_100_000 + 4000 * i - (8000 if i % 50 == 49 else 0), 9.5) for i in range(200))
    with pytest.raises(files.BadFile, match="repeatedly: 4 of 220"):
        read(whole() + often)


def test_a_row_of_another_time_is_left_out():
    table = read(whole() + motion(1 << 60, 1.0) + motion(1_100_000, 1.0))
    assert len(table) == 25
    assert table.notes[0] == "1 messages with a time that is not near the start of the ULog are left out."
