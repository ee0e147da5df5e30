using Engraver.App.Desk;
using Engraver.Benchmarks.Canvas;
using Engraver.Core.Drawings;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.App.Tests.Desk;

public class MemoryReclaimerTests
{
    [Fact]
    public void A_large_drawing_is_collected_after_once_when_it_came_and_once_when_it_went()
    {
        var collected = 0;
        var memory = new MemoryReclaimer(() => false, action => action(), Collect);
        var (large, small) = (Of(BenchmarkDrawing.Create(MemoryReclaimer.LargeDrawingCurves)), Of(BenchmarkDrawing.Create(100)));
        memory.OnDerivedChanged(small);
        Assert.Equal(0, collected);
        memory.OnDerivedChanged(large);
        memory.OnDerivedChanged(large);
        Assert.Equal(1, collected);
        memory.OnDerivedChanged(new DerivedDocument(large.State with { Selection = [0] }, MachineFamilies.Default.DefaultStrategy)); // an edit of the same drawing
        Assert.Equal(1, collected);
        memory.OnDerivedChanged(small);
        memory.OnDerivedChanged(small);
        Assert.Equal(2, collected);
        Assert.True(memory.IsDone);

        Task Collect() => Task.FromResult(collected++);
    }

    [Fact]
    public async Task A_closed_drawing_is_collected_a_moment_later_when_its_last_picture_is_gone()
    {
        var (waiting, collected, done) = (new Queue<Action>(), 0, new TaskCompletionSource());
        var memory = new MemoryReclaimer(() => false, waiting.Enqueue, Collect);
        memory.OnDerivedChanged(Of(BenchmarkDrawing.Create(MemoryReclaimer.LargeDrawingCurves)));
        memory.OnDerivedChanged(Of(BenchmarkDrawing.Create(100)));
        Assert.Equal((0, 1, false), (collected, waiting.Count, memory.IsDone)); // two reasons, one collection
        waiting.Dequeue()();
        Assert.Equal((1, false), (collected, memory.IsDone));
        done.SetResult();
        await memory.LastCollection;
        Assert.True(memory.IsDone);

        Task Collect()
        {
            collected++;
            return done.Task;
        }
    }

    [Fact]
    public void A_machine_that_began_to_move_meanwhile_is_not_held_up()
    {
        var (waiting, moves, collected) = (new Queue<Action>(), false, 0);
        var memory = new MemoryReclaimer(() => moves, waiting.Enqueue, Collect);
        var large = Of(BenchmarkDrawing.Create(MemoryReclaimer.LargeDrawingCurves));
        memory.OnDerivedChanged(large);
        moves = true;
        waiting.Dequeue()();
        memory.OnDerivedChanged(large);
        Assert.Equal((0, 0, false), (collected, waiting.Count, memory.IsDone));
        moves = false;
        memory.OnDerivedChanged(large);
        waiting.Dequeue()();
        Assert.Equal((1, true), (collected, memory.IsDone));

        Task Collect() => Task.FromResult(collected++);
    }

    [Fact]
    public void Nothing_is_collected_while_the_machine_moves_and_it_is_made_up_for()
    {
        var (moves, collected) = (true, 0);
        var memory = new MemoryReclaimer(() => moves, action => action(), Collect);
        var large = Of(BenchmarkDrawing.Create(MemoryReclaimer.LargeDrawingCurves));
        memory.OnDerivedChanged(large);
        Assert.Equal(0, collected);
        moves = false;
        memory.OnDerivedChanged(large);
        Assert.Equal(1, collected);

        Task Collect() => Task.FromResult(collected++);
    }

    private static DerivedDocument Of(Drawing drawing) => new(new DocumentState { Drawing = drawing }, MachineFamilies.Default.DefaultStrategy);
}
