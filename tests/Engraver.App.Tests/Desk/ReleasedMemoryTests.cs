using Engraver.App.Desk;
using Engraver.Benchmarks.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.App.Tests.Desk;

public class ReleasedMemoryTests
{
    [Fact]
    public void A_large_drawing_is_collected_after_once_when_it_came_and_once_when_it_went()
    {
        var collected = 0;
        var memory = new ReleasedMemory(() => false, () => collected++);
        var (large, small) = (Of(BenchmarkDrawing.Create(ReleasedMemory.LargeDrawing)), Of(BenchmarkDrawing.Create(100)));
        memory.Look(small);
        Assert.Equal(0, collected);
        memory.Look(large);
        memory.Look(large);
        Assert.Equal(1, collected);
        memory.Look(new DerivedDocument(large.State with { Selection = [0] }, JobMode.Stream)); // an edit of the same drawing
        Assert.Equal(1, collected);
        memory.Look(small);
        memory.Look(small);
        Assert.Equal(2, collected);
    }

    [Fact]
    public void Nothing_is_collected_while_the_machine_moves_and_it_is_made_up_for()
    {
        var (moves, collected) = (true, 0);
        var memory = new ReleasedMemory(() => moves, () => collected++);
        var large = Of(BenchmarkDrawing.Create(ReleasedMemory.LargeDrawing));
        memory.Look(large);
        Assert.Equal(0, collected);
        moves = false;
        memory.Look(large);
        Assert.Equal(1, collected);
    }

    private static DerivedDocument Of(Drawing drawing) => new(new DocumentState { Drawing = drawing }, JobMode.Stream);
}
