using Engraver.Core.Machines;
using Engraver.Links.Recording;
using Engraver.TestKit;

namespace Engraver.Links.Tests.Recording;

/// <summary>The bytes sent over the links of a machine are recorded, and read back unchanged.</summary>
public class ConversationTests
{
    [Fact]
    public async Task Every_byte_comes_back_with_its_time_and_its_link()
    {
        var (time, text) = (new ManualTimeProvider(), new StringWriter { NewLine = "\n" });
        var recorder = new ConversationRecorder(text, time, ConversationClock.Wall, time);
        await using var first = recorder.Record(new SilentLink());
        time.Advance(TimeSpan.FromTicks(12_345));
        var second = recorder.Record(new SilentLink());
        byte[] every = [.. Enumerable.Range(0, 256).Select(value => (byte)value)];
        await first.WriteAsync("DL\r#A\\"u8.ToArray(), CancellationToken.None);
        time.Advance(TimeSpan.FromMilliseconds(1));
        await second.WriteAsync(every, CancellationToken.None);
        await second.DisposeAsync();
        await second.DisposeAsync();
        await recorder.CloseAsync(CancellationToken.None);
        var back = Conversation.Read(new StringReader(text.ToString()));

        Assert.Equal((false, true), (back.IsControllersClock, back.IsWhole));
        Assert.Equal(
            [(0L, 0, ConversationEvent.Opened), (12_345L, 1, ConversationEvent.Opened), (12_345L, 0, ConversationEvent.Said), (22_345L, 1, ConversationEvent.Said), (22_345L, 1, ConversationEvent.Closed)],
            back.Steps.Select(step => (step.Ticks, step.Link, step.Event)));
        Assert.Equal(every, back.Steps[3].Bytes);
        Assert.Contains("12345 0 > DL\\r#A\\\\\n", text.ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("#wire;1;controller\n5 0 +\n7 0 > ST", true, 2)]
    [InlineData("#wire;1;controller\n5 0 +\n7 0 > ST\\x", true, 1)]
    [InlineData("#wire;1;controller\n5 0 +\n7 0", true, 1)]
    [InlineData("#wire;1;controller\n", true, 0)]
    public void A_file_that_a_crash_has_cut_off_is_read_up_to_its_last_whole_line(string text, bool isExact, int steps)
    {
        var read = Conversation.Read(new StringReader(text));

        Assert.Equal((isExact, false, steps), (read.IsControllersClock, read.IsWhole, read.Steps.Count));
    }

    [Theory]
    [InlineData("")]
    [InlineData("{\"kind\":\"job\"}\n")]
    [InlineData("#wire;2;controller\n")]
    [InlineData("#wire;1;controller\nnonsense\n5 0 +\n")]
    [InlineData("#wire;1;controller\n-5 0 +\n5 0 +\n")]
    public void Another_file_is_refused(string text) => Assert.Throws<FormatException>(() => Conversation.Read(new StringReader(text)));

    private sealed class SilentLink : IControllerLink
    {
        public string Description => "";

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => ValueTask.CompletedTask;

        public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => ValueTask.FromResult(0);

        public ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }
}
