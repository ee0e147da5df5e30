using System.Numerics;
using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Sending;

namespace Engraver.Core.Tests.Sending;

public class SendTextTests
{
    [Fact]
    public void The_parity_bit_makes_the_ones_even_or_odd_and_is_taken_off_again()
    {
        for (var character = 0; character < 128; character++)
        {
            var even = CharacterFrame.SevenEven.Encode((byte)character);
            var odd = CharacterFrame.SevenOdd.Encode((byte)character);

            Assert.Equal((0, 1), (BitOperations.PopCount(even) % 2, BitOperations.PopCount(odd) % 2));
            Assert.Equal((character, character), (CharacterFrame.SevenEven.Decode(even), CharacterFrame.SevenOdd.Decode(odd)));
            Assert.True(CharacterFrame.SevenEven.HasValidParity(even));
            Assert.False(CharacterFrame.SevenEven.HasValidParity(odd));
            Assert.Equal(character, CharacterFrame.EightNone.Encode((byte)character));
        }
    }

    /// <summary>The characters of the ISO tape code (ISO 646 with even parity): 0 is 30 hexadecimal, 1 is B1, CR is 8D, LF is 0A, % is A5.</summary>
    [Theory]
    [InlineData('0', 0x30)]
    [InlineData('1', 0xB1)]
    [InlineData('\r', 0x8D)]
    [InlineData('\n', 0x0A)]
    [InlineData('%', 0xA5)]
    public void The_tape_code_has_these_bits(char character, byte bits) => Assert.Equal(bits, CharacterFrame.SevenEven.Encode((byte)character));

    [Theory]
    [InlineData("A\nB\r\nC\rD", new[] { "A", "B", "C", "D" })]
    [InlineData("A\n\nB\n", new[] { "A", "", "B" })]
    [InlineData("\r\n", new[] { "" })]
    [InlineData("", new string[0])]
    public void A_line_ends_with_CR_LF_or_both(string file, string[] lines) =>
        Assert.Equal(lines, SendText.Lines(Encoding.Latin1.GetBytes(file)).Select(line => Encoding.Latin1.GetString(line.Span)));

    [Fact]
    public void Leader_start_lines_end_and_trailer_stand_in_this_order()
    {
        var format = new SendFormat { LeaderNuls = 3, Start = "%\r", LineEnd = "\n", End = "\u0004", TrailerNuls = 2 };
        var job = SendText.Encode(SendText.Lines("G1\r\nG2"u8.ToArray()), format, CharacterFrame.EightNone).Job!;

        Assert.Equal("\0\0\0%\r|G1\n|G2\n|\u0004\0\0", string.Join('|', [Text(job.Leader), .. job.Lines.Select(Text), Text(job.Trailer)]));
        Assert.Equal(14, job.Length);

        static string Text(ReadOnlyMemory<byte> bits) => Encoding.Latin1.GetString(bits.Span);
    }

    [Fact]
    public void A_character_of_eight_bits_is_refused_for_seven_with_its_place()
    {
        var lines = SendText.Lines(Encoding.Latin1.GetBytes("G1 X1\nG2 \u00FCber\n"));

        var refused = SendText.Encode(lines, SendFormat.Default, CharacterFrame.SevenEven);
        Assert.Null(refused.Job);
        Assert.Equal(("SND0002", 2), (refused.Refusal!.Id, refused.Refusal.Source.Line));
        Assert.Contains("Character 252 in column 4 of line 2 cannot be sent with the frame 7E1.", refused.Refusal.Message, StringComparison.Ordinal);
        Assert.NotNull(SendText.Encode(lines, SendFormat.Default, CharacterFrame.EightNone).Job);
        Assert.Equal("SND0001", SendText.Encode([], SendFormat.Default, CharacterFrame.EightNone).Refusal!.Id);
    }

    [Fact]
    public void Programs_for_a_wire_eroder_begin_with_their_mark_and_have_999_blocks_at_most()
    {
        var two = SendText.AgiePrograms(SendText.Lines("%\t001\n\t002\n%\t001\n"u8.ToArray()));
        var full = SendText.Lines(Encoding.ASCII.GetBytes("%\n" + string.Concat(Enumerable.Repeat("\t001\n", 999))));
        var over = SendText.Lines(Encoding.ASCII.GetBytes("%\t001\n" + string.Concat(Enumerable.Repeat("\t001\n", 999))));

        Assert.Equal([2, 1], two.Select(program => program.Count));
        Assert.Single(SendText.AgiePrograms(full));
        Assert.Null(SendText.TooLong(full));
        Assert.Equal("The program has 1000 blocks; the controller accepts at most 999.", SendText.TooLong(over)!.Sentence);
    }

    [Theory]
    [InlineData("a\\r\\n", "a\r\n")]
    [InlineData("\\x1A\\\\", "\u001A\\")]
    [InlineData("%", "%")]
    [InlineData("\\", null)]
    [InlineData("\\q", null)]
    [InlineData("\\x1", null)]
    public void What_cannot_be_typed_is_written_with_a_backslash(string typed, string? meant) => Assert.Equal(meant, SendFormat.Unescape(typed));

    [Fact]
    public void An_address_says_device_rate_frame_and_flow()
    {
        Assert.True(SendAddress.TryParse("serial:///dev/ttyS0?baud=300&frame=7e1&flow=rtscts", out var address));
        Assert.Equal(new SendAddress("/dev/ttyS0", 300, CharacterFrame.SevenEven, SerialFlow.RtsCts), address);
        Assert.True(SendAddress.TryParse(address.ToString(), out var again));
        Assert.Equal(address, again);
        Assert.True(SendAddress.TryParse("serial://COM3?driver=ports", out var chosen));
        Assert.Equal((SerialDriver.Ports, "serial://COM3?baud=9600&frame=8N1&flow=xonxoff&driver=ports"), (chosen.Driver, chosen.ToString()));
        Assert.True(SendAddress.TryParse("serial:///dev/ttyS0", out var usual));
        Assert.Equal(new SendAddress("/dev/ttyS0", 9600, CharacterFrame.EightNone, SerialFlow.XonXoff), usual);
    }

    [Theory]
    [InlineData("tcp://localhost")]
    [InlineData("serial://")]
    [InlineData("serial:///dev/ttyS0?baud=9601")]
    [InlineData("serial:///dev/ttyS0?frame=7N1")]
    [InlineData("serial:///dev/ttyS0?flow=hardware")]
    [InlineData("serial:///dev/ttyS0?speed=1")]
    [InlineData("serial:///dev/ttyS0?driver=usb")]
    public void What_is_no_line_is_refused(string typed) => Assert.False(SendAddress.TryParse(typed, out _));
}
