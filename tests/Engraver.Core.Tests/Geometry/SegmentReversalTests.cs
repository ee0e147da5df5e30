using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Geometry;

public class SegmentReversalTests
{
    [Property]
    public Property Reversing_twice_is_the_identity() =>
        Prop.ForAll(Arcs.Any, arc =>
        {
            var segment = Segment.FromArc(arc);
            var twice = segment.Reversed().Reversed();
            return twice.Start == segment.Start
                && twice.End == segment.End
                && twice.Arc.Sweep == arc.Sweep
                && Math.Abs(twice.Arc.Start.Degrees - arc.Start.Degrees) <= 1e-9;
        });

    [Property]
    public Property A_reversed_arc_passes_the_same_points_the_other_way() =>
        Prop.ForAll(Arcs.Any, arc =>
        {
            var (there, back) = (Segment.FromArc(arc), Segment.FromArc(arc).Reversed());
            return new[] { 0.0, 0.25, 0.5, 1.0 }.All(fraction => there.PointAt(fraction).IsNear(back.PointAt(1.0 - fraction), 1e-9 * (arc.Radius + 1000.0)));
        });

    [Fact]
    public void An_arc_given_with_its_ends_keeps_them_exactly()
    {
        var (start, end) = (new Point2D(10.000000001, 0), new Point2D(0, 9.999999999));
        var arc = new ArcSegment(default, 10, Angle.Zero, Angle.FromDegrees(90));

        var reversed = Segment.FromArc(arc, start, end).Reversed();

        Assert.Equal((end, start), (reversed.Start, reversed.End));
    }

    [Property]
    public Property A_table_row_cut_backwards_is_the_reversed_segment() =>
        Prop.ForAll(Arcs.Any, arc =>
        {
            var drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, Segment.FromArc(arc)).Build();
            var table = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default));
            var drawn = table[0].ToSegment();

            var cut = Sequencer.Sequence(table, null, UsualOptions.Sequencing with { ToolStart = drawn.End, JoinTolerance = 0.0 }).Strokes[0].Moves[0].Segment;

            return cut.Start == drawn.End
                && cut.End == drawn.Start
                && cut.Arc.Sweep == -arc.Sweep
                && cut.PointAt(0.3).IsNear(drawn.PointAt(0.7), 1e-9 * (arc.Radius + 1000.0));
        });
}
