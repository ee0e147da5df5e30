using System.Text;
using Engraver.Core.Sending;
using Engraver.TestKit;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Tests.Sending;

public class ProgramReceiverTests
{
    private static readonly TimeSpan s_silence = TimeSpan.FromSeconds(5);

    [Fact]
    public async Task A_line_on_which_nothing_ever_comes_is_given_up_after_the_silence()
    {
        var time = new ManualTimeProvider();
        var receiver = new ProgramReceiver(CharacterFrame.EightNone);
        var listening = receiver.ListenAsync(new MemoryPort(time), s_silence, progress: null, time, CancellationToken.None);
        time.Advance(s_silence - TimeSpan.FromMilliseconds(1));
        Assert.False(listening.IsCompleted);
        time.Advance(TimeSpan.FromMilliseconds(1));

        Assert.True(await listening.WaitAsync(TimeSpan.FromSeconds(60)));
        Assert.Empty(receiver.Characters);
    }

    /// <summary>A leader of NULs is not part of the program, but shows that the sender is active. A slow progress handler does not matter.</summary>
    [Theory]
    [InlineData("\0")]
    [InlineData("G")]
    public async Task Every_character_begins_the_silence_anew(string said)
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time);
        var receiver = new ProgramReceiver(CharacterFrame.EightNone);
        using var heard = new LineProgress { WhenTold = () => time.Advance(s_silence - TimeSpan.FromMilliseconds(1)) };
        var listening = receiver.ListenAsync(line, s_silence, heard, time, CancellationToken.None);
        for (var i = 0; i < 3; i++)
        {
            line.Receive((byte)said[0]);
            await heard.NextAsync();
        }

        Assert.False(listening.IsCompleted);
        time.Advance(TimeSpan.FromMilliseconds(1));
        Assert.True(await listening.WaitAsync(TimeSpan.FromSeconds(60)));
        Assert.Equal(said == "G" ? "GGG" : "", Encoding.ASCII.GetString([.. receiver.Characters]));
    }

    [Fact]
    public async Task A_program_that_the_operator_stopped_is_not_called_whole()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time);
        using var stop = new CancellationTokenSource();
        using var heard = new LineProgress();
        var listening = new ProgramReceiver(CharacterFrame.EightNone).ListenAsync(line, s_silence, heard, time, stop.Token);
        line.Receive((byte)'G');
        await heard.NextAsync();
        await stop.CancelAsync();

        Assert.False(await listening.WaitAsync(TimeSpan.FromSeconds(60)));
    }

    private sealed class LineProgress : IProgress<int>, IDisposable
    {
        private readonly SemaphoreSlim _pieces = new(0);

        public Action WhenTold { get; init; } = () => { };

        public void Report(int value)
        {
            WhenTold();
            _pieces.Release();
        }

        public void Dispose() => _pieces.Dispose();

        public async Task NextAsync() => Assert.True(await _pieces.WaitAsync(TimeSpan.FromSeconds(60)));
    }
}
