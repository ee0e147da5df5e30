using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Galil.Tests.Protocol;

public class ReplyFramerTests
{
    [Theory]
    [InlineData(":", "+")]
    [InlineData("?", "-")]
    [InlineData(" 5.0000\r\n:", "+ 5.0000\r\n")]
    [InlineData(":::", "+|+|+")]
    [InlineData(":?:", "+|-|+")]
    [InlineData("x=4:y=5\r\n:", "+x=4:y=5\r\n")]
    [InlineData(" 1.0000\r\n: 2.0000\r\n:", "+ 1.0000\r\n|+ 2.0000\r\n")]
    public void Every_prompt_at_the_start_of_a_line_is_a_reply(string bytes, string expected) => Assert.Equal(expected, FramesOf(bytes, ReplyShape.Text));

    [Fact]
    public void An_upload_ends_at_the_prompt_behind_its_end_mark_whatever_the_program_prints()
    {
        Assert.Equal("+#A\r\n:?\r\nEN\r\n\x1A", FramesOf("#A\r\n:?\r\nEN\r\n\x1A:", ReplyShape.Upload));
        Assert.Equal("+\r\n\x1A", FramesOf("\r\n\x1A:", ReplyShape.Upload));
        Assert.Equal("-", FramesOf("?", ReplyShape.Upload));
    }

    [Fact]
    public void A_record_is_taken_by_its_length_with_prompts_and_bit_7_inside()
    {
        Assert.Equal("+\x87:?\xFF", FramesOf("\x87:?\xFF:", ReplyShape.Record, 4));
        Assert.Equal("-", FramesOf("?", ReplyShape.Record, 4));
    }

    [Fact]
    public void Marked_bytes_are_messages_even_in_the_middle_of_a_number()
    {
        var messages = new List<string>();
        var framer = new ReplyFramer { MessageReceived = messages.Add };

        framer.Append(Bytes(" 12"));
        framer.Append([.. Bytes("HOST LOST?\r\n").Select(value => (byte)(value | 0x80))]);
        framer.Append(Bytes("34\r\n:"));

        Assert.Equal(["HOST LOST?"], messages);
        Assert.True(framer.TryTake(out var frame));
        Assert.Equal(" 1234\r\n", frame.Data);
    }

    [Fact]
    public void The_extra_colon_after_a_trailing_semicolon_is_not_taken_for_the_next_reply()
    {
        var framer = new ReplyFramer();
        framer.Append(Bytes("::"));
        framer.TryTake(out _);

        framer.Expect(ReplyShape.Text, 0);
        framer.Append(Bytes("?"));

        Assert.True(framer.TryTake(out var frame));
        Assert.False(frame.Accepted);
    }

    [Fact]
    public void Endless_bytes_without_a_prompt_are_no_controller()
    {
        var framer = new ReplyFramer();

        Assert.Throws<ProtocolViolationException>(() => framer.Append(new byte[ReplyFramer.LongestReply + 1]));
    }

    [Property]
    public Property However_the_bytes_are_split_the_replies_are_the_same()
    {
        const string Wire = " 1.0000\r\n:?\r\n 17 ED, BN\r\n:\xC8\xCF\x8D\x8Ax:y\r\n:::?";
        return Prop.ForAll(Gen.Choose(0, Wire.Length).ToArrays(), places =>
        {
            var framer = new ReplyFramer();
            var from = 0;
            foreach (var to in places.Append(Wire.Length).Order())
            {
                framer.Append(Bytes(Wire[from..to]));
                from = to;
            }

            return Taken(framer) == FramesOf(Wire, ReplyShape.Text);
        });
    }

    private static byte[] Bytes(string text) => Encoding.Latin1.GetBytes(text);

    private static string FramesOf(string bytes, ReplyShape shape, int recordLength = 0)
    {
        var framer = new ReplyFramer();
        framer.Expect(shape, recordLength);
        framer.Append(Bytes(bytes));
        return Taken(framer);
    }

    private static string Taken(ReplyFramer framer)
    {
        var frames = new List<string>();
        while (framer.TryTake(out var frame)) frames.Add((frame.Accepted ? "+" : "-") + frame.Data);
        return string.Join('|', frames);
    }
}
