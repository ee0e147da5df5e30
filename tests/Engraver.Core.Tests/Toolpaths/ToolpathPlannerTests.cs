using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Toolpaths;

public class ToolpathPlannerTests
{
    [Fact]
    public void The_toolpath_has_the_strokes_in_order_and_a_gap_within_the_tolerance_stays_as_drawn()
    {
        var drawing = new DrawingBuilder().Line(20, 0, 30, 0).Line(0, 0, 5, 0).Line(5.004, 0, 9, 0).Build();
        var sequenced = Sequencer.Sequence(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), drawing, UsualOptions.Sequencing);

        var path = ToolpathPlanner.Plan(sequenced, new Point2D(-1, 0), 0.001);

        Assert.Equal(new Point2D(-1, 0), path.ToolStart);
        Assert.Equal([1, 2], path.Strokes[0].Moves.Select(move => move.EntityIndex));
        Assert.Equal((5.0, 5.004), (path.Strokes[0].Moves[0].Segment.End.X, path.Strokes[0].Moves[1].Segment.Start.X));
        Assert.Equal((1, 20.0, false), (path.Strokes[1].Index, path.Strokes[1].Start.X, path.Strokes[1].Closed));
    }
}
