using Engraver.App.Desk;
using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.App.Tests.Desk;

public sealed class FirstPictureGateTests
{
    private static readonly Drawing s_large = Lines(50_000);
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private readonly ManualTimeProvider _clock = new();
    private readonly FirstPictureGate _first;

    public FirstPictureGateTests() => _first = new FirstPictureGate(_clock);

    [Fact]
    public void Nothing_is_waited_for_where_the_picture_is_quick_or_there_is_none()
    {
        Assert.True(_first.WhenShown(null).IsCompletedSuccessfully);
        Assert.True(_first.WhenShown(Lines(100)).IsCompletedSuccessfully);
    }

    [Fact]
    public async Task A_large_drawing_is_waited_for_until_its_own_picture_is_there()
    {
        var awaited = _first.WhenShown(s_large);
        _first.OnShown(null);
        _first.OnShown(Lines(100));
        Assert.False(awaited.IsCompleted);
        _first.OnShown(s_large);

        await awaited.WaitAsync(s_patience);
        Assert.True(_first.WhenShown(s_large).IsCompletedSuccessfully);
        _first.OnShown(null);
        Assert.False(_first.WhenShown(s_large).IsCompleted); // opened again, it is drawn again
    }

    [Fact]
    public async Task A_drawing_in_the_place_of_another_lets_that_go()
    {
        var awaited = _first.WhenShown(s_large);
        var other = _first.WhenShown(Lines(50_001));

        await awaited.WaitAsync(s_patience);
        Assert.False(other.IsCompleted);
    }

    /// <summary>The drawing is closed, or another one opened, before its picture exists.</summary>
    [Fact]
    public async Task A_drawing_that_is_gone_is_let_go()
    {
        var awaited = _first.WhenShown(s_large);
        Assert.True(_first.WhenShown(null).IsCompletedSuccessfully);
        await awaited.WaitAsync(s_patience);
        var (again, held) = Awaited();
        Assert.True(_first.WhenShown(Lines(100)).IsCompletedSuccessfully);
        await again.WaitAsync(s_patience);
        GC.Collect();
        Assert.False(held.TryGetTarget(out _));

        [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
        (Task, WeakReference<Drawing>) Awaited()
        {
            var drawing = Lines(50_000);
            return (_first.WhenShown(drawing), new WeakReference<Drawing>(drawing));
        }
    }

    [Fact]
    public async Task A_picture_that_does_not_come_is_not_waited_for()
    {
        var awaited = _first.WhenShown(s_large);
        _clock.Advance(TimeSpan.FromSeconds(1.9));
        Assert.False(awaited.IsCompleted);
        _clock.Advance(TimeSpan.FromSeconds(0.2));

        await Assert.ThrowsAsync<TimeoutException>(() => awaited);
    }

    private static Drawing Lines(int count)
    {
        var builder = new DrawingBuilder();
        for (var i = 0; i < count; i++) builder.Line(i, 0, i, 1);
        return builder.Build();
    }
}
