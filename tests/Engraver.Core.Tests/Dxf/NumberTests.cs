using System.Globalization;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Numbers and lines as read by the fast parser, compared with the library.</summary>
public class NumberTests
{
    [Theory]
    [InlineData(16)]
    [InlineData(17)]
    [InlineData(18)]
    [InlineData(19)]
    [InlineData(20)]
    public void Long_numbers_are_rounded_as_the_library_rounds_them(int digits)
    {
        var random = new Random(digits);
        AssertRead([.. Enumerable.Range(0, 4000).Select(_ => Written(random, digits))]);
    }

    [Theory]
    [InlineData("9007199254740993")] // exactly between two doubles
    [InlineData("9007199254740995")]
    [InlineData("900719925474099.25")]
    [InlineData("4503599627370496.5")]
    [InlineData("4503599627370497.5")]
    [InlineData("0.3333333333333333333")]
    [InlineData("-0.0000000000000000001")]
    [InlineData("1844674407370955161.5")]
    [InlineData("18446744073709551615")]
    [InlineData("18446744073709551616")]
    [InlineData("9999999999999999999")]
    [InlineData("0.1000000000000000055")]
    [InlineData("-.5")]
    [InlineData("5.")]
    [InlineData("+3.25")]
    [InlineData("  7.5 ")]
    [InlineData("12.5e-1")]
    [InlineData("-0.0")]
    public void Awkward_spellings_mean_what_they_say(string text) => AssertRead([text]);

    [Theory]
    [InlineData(".")]
    [InlineData("-")]
    [InlineData("1.2.3")]
    [InlineData("--1")]
    [InlineData("1e")]
    public void What_is_no_number_is_refused(string text) =>
        Assert.Equal("DXF0007", Assert.Single(DxfReading.Entities((0, "LINE"), (10, text), (20, 0), (11, 1), (21, 0)).Balance.Refused).DiagnosticId);

    [Theory]
    [InlineData("0", 0)]
    [InlineData("2f", 0x2F)]
    [InlineData("FFFFFFFFFFFFFFFF", ulong.MaxValue)]
    [InlineData("10000000000000000", 0)]
    [InlineData(" 1A ", 0x1A)]
    [InlineData("1G", 0)]
    public void Handles_are_hexadecimal(string text, ulong handle) =>
        Assert.Equal(handle, DxfReading.Entities((0, "LINE"), (5, text), (10, 0), (20, 0), (11, 1), (21, 0)).Entities[0].Handle);

    /// <summary>Lines are searched sixteen bytes at a time, and near the end of the file one by one.</summary>
    [Fact]
    public void A_line_ends_where_it_ends_whatever_its_length()
    {
        for (var length = 0; length <= 100; length++)
        {
            foreach (var end in new[] { "\n", "\r\n", "\r" })
            {
                var text = DxfText.WithEntities((1, new string('x', length)), (0, "LINE"), (1, new string('y', 100 - length)), (10, 1), (20, 2), (11, 3), (21, 4)).ToAscii(end);
                var part = Assert.Single(DxfReading.Parts(DxfReading.Of(text)));
                Assert.Equal((1.0, 2.0, 3.0, 4.0), (part.A, part.B, part.D, part.E));
            }
        }
    }

    private static string Written(Random random, int digits)
    {
        var text = string.Concat(Enumerable.Range(0, digits).Select(i => (char)('0' + random.Next(i == 0 ? 1 : 0, 10))));
        var point = random.Next(0, digits + 1);
        return (random.Next(2) == 0 ? "-" : "") + (point == digits ? text : $"{text[..point]}.{text[point..]}");
    }

    private static void AssertRead(string[] numbers)
    {
        (int Code, object Value)[] pairs = [.. numbers.SelectMany(number => new (int, object)[] { (0, "LINE"), (10, number), (20, 0), (11, 1e99), (21, 0) })];
        var parts = DxfReading.Parts(DxfReading.Entities(pairs));

        Assert.Equal(numbers.Length, parts.Length);
        for (var i = 0; i < numbers.Length; i++)
        {
            var expected = double.Parse(numbers[i], CultureInfo.InvariantCulture);
            Assert.True(BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(parts[i].A), $"{numbers[i]} was read as {parts[i].A:R}");
        }
    }
}
