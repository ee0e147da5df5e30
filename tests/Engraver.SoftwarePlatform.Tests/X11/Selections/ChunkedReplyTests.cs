using Engraver.SoftwarePlatform.X11.Selections;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.X11.Selections;

public sealed class ChunkedReplyTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(5);
    private readonly ManualTimeProvider _time = new();

    [Fact]
    public async Task A_slow_answer_is_waited_for_while_pieces_come()
    {
        using var answer = new ChunkedReply(s_patience, _time);
        for (var piece = 0; piece < 10; piece++)
        {
            _time.Advance(TimeSpan.FromSeconds(4));
            answer.OnPiece();
        }

        Assert.False(answer.Whole.IsCompleted);
        answer.Complete([1, 2]);
        Assert.Equal([1, 2], (await answer.Whole)!);
        Assert.False(answer.TimedOut);
    }

    [Fact]
    public async Task Silence_ends_the_waiting()
    {
        using var answer = new ChunkedReply(s_patience, _time);
        _time.Advance(TimeSpan.FromSeconds(4));
        answer.OnPiece();
        _time.Advance(s_patience);

        Assert.Null(await answer.Whole);
        Assert.True(answer.TimedOut);
        answer.Complete([1]);
        Assert.Null(await answer.Whole);
    }
}
