using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Playback;

public class PlannedMotionTests
{
    [Theory]
    [InlineData("gasket.dxf")]
    [InlineData("paper-001.dxf")]
    [InlineData("nested-logo.dxf")]
    public void Playing_a_sample_takes_the_planned_time_and_jumps_nowhere(string sample)
    {
        var (job, motion) = Motion(sample);
        var program = job.Motion.Program!;
        Assert.Equal(JobPlan.NetworkTimes(program).Total, motion.DurationSeconds, precision: 9);
        var fastest = Math.Sqrt(2) * program.Profile.RapidMmPerMinute / 60.0;
        var (steps, last) = (2000, motion.At(0.0));
        for (var i = 1; i <= steps; i++)
        {
            var at = motion.At(motion.DurationSeconds * i / steps);
            Assert.InRange(at.Position.DistanceTo(last.Position), 0.0, (fastest * motion.DurationSeconds / steps) + 0.003); // The predicted end of an arc is rounded to counts.
            last = at;
        }

        Assert.Equal(program.Finish, program.Profile.Scale.ToCounts(last.Position));
        Assert.Equal(program.Start, program.Profile.Scale.ToCounts(motion.At(-5).Position));
    }

    [Theory]
    [InlineData("gasket.dxf")]
    [InlineData("nested-logo.dxf")]
    [InlineData("clock-dial.dxf")]
    public void While_the_tool_cuts_it_is_on_its_row_and_its_entity(string sample)
    {
        var (job, motion) = Motion(sample);
        var table = job.Sequence.Table;
        for (var segment = 0; segment < motion.SegmentCount; segment++)
        {
            var begins = motion.TimeOfSegment(segment);
            var later = motion.At(begins + 0.05);
            var at = later.Segment == segment ? later : motion.At(begins + 1e-6); // Well inside, where two rows do not meet.
            Assert.Equal(segment, at.Segment);
            Assert.Equal(at.Entity, table.EntityIndexOf(at.Row));
            Assert.InRange(table[at.Row].ToSegment().DistanceTo(at.Position), 0.0, 0.03); // the arc at a corner belongs to the row after it
        }
    }

    /// <summary>An ellipse is one row of the table and many moves of the toolpath: progress is given by moves, otherwise the canvas highlights another part of
    /// the drawing (regression: an ellipse before two circles).</summary>
    [Fact]
    public void A_segment_of_an_ellipse_is_on_its_move_and_what_follows_on_its_own()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Circle(0, 0, 3).Free(FreeCurves.Ellipse(20, 0, 12, 0.6, 0, 0, 360).ToCurve()).Line(40, 0, 50, 0).Line(50, 0, 50, 10).Build(), new DrawingSettings { CornerToleranceMm = 0.0 }, MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        StrokeMove[] moves = [.. job.Toolpath.Strokes.SelectMany(stroke => stroke.Moves)];
        Assert.True(moves.Length > job.Sequence.Table.Count + 3, $"{moves.Length} moves");
        for (var segment = 0; segment < motion.SegmentCount; segment++)
        {
            var at = motion.At(motion.TimeOfSegment(segment) + 0.005);
            Assert.Equal((segment, at.Entity, at.Entity), (at.Segment, moves[at.Move].EntityIndex, job.Sequence.Table.EntityIndexOf(at.Row)));
            Assert.InRange(moves[at.Move].Segment.DistanceTo(at.Position), 0.0, 0.004);
        }

        Assert.Equal(moves.Length - 1, motion.At(motion.TimeOfSegment(motion.SegmentCount - 1)).Move);
        Assert.Equal(motion.TimeOfSegment(motion.SegmentCount - 1), motion.TimeOfMove(moves.Length - 1));
        Assert.Null(motion.TimeOfMove(moves.Length));
    }

    /// <summary>With unequal axes an arc is cut as many chords, which all are its move.</summary>
    [Theory]
    [InlineData(1000.0, 800.0)]
    [InlineData(-1000.0, 800.0)]
    [InlineData(-1000.0, -800.0)]
    public void A_chord_of_an_arc_is_on_the_move_of_the_arc_whatever_axis_is_mirrored(double x, double y)
    {
        var arc = new ArcSegment(new Point2D(10.0, 5.0), 5.0, Angle.FromDegrees(-90.0), Angle.FromDegrees(180.0));
        var drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, Segment.FromLine(new(0, 0), new(10, 0)), Segment.FromArc(arc), Segment.FromLine(new(10, 10), new(0, 10))).Build();
        var job = JobPreparation.Prepare(drawing, new DrawingSettings { Machine = MachineProfile.Default with { Axes = MachineAxes.FromScale(x, y) } }, MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.DriverOf(job.Motion.Program!.Profile).NetworkTimes, null, CancellationToken.None);
        int[] moves = [.. Enumerable.Range(0, motion.SegmentCount).Select(segment => motion.At(motion.TimeOfSegment(segment) + 1e-6).Move)];

        Assert.Equal([0, 1, 2], moves.Where((move, i) => i == 0 || move != moves[i - 1]));
        Assert.True(moves.Length > 10, $"{moves.Length} segments");
    }

    /// <summary>The picked object on the canvas, the highlighted table row and the rows of the properties are the same object.</summary>
    [Theory]
    [InlineData("gasket.dxf")]
    [InlineData("paper-001.dxf")]
    [InlineData("nested-logo.dxf")]
    [InlineData("clock-dial.dxf")]
    [InlineData("nameplate.dxf")]
    public void The_moment_at_which_an_entity_or_a_row_begins_is_its_own(string sample)
    {
        var (job, motion) = Motion(sample);
        var table = job.Sequence.Table;
        for (var row = 0; row < table.Count; row++)
        {
            if (motion.TimeOfRow(row) is not { } begins) continue;
            Assert.Equal(row, motion.At(begins).Row);
            var entity = table.EntityIndexOf(row);
            var first = Enumerable.Range(0, table.Count).First(other => table.EntityIndexOf(other) == entity && motion.TimeOfRow(other) is not null);
            Assert.Equal((entity, first), (motion.At(motion.TimeOfEntity(entity)!.Value).Entity, motion.At(motion.TimeOfEntity(entity)!.Value).Row));
        }
    }

    [Fact]
    public void The_program_line_under_the_tool_is_the_one_that_commands_it()
    {
        var (job, motion) = Motion("gasket.dxf");
        var text = DmcPost.Sequences(job.Motion.Program!, DmcPostOptions.Default, job.Drawing.SourceOf).Text.Split('\n');
        var place = 0;
        foreach (var sequence in job.Motion.Program!.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            foreach (var segment in sequence.Segments)
            {
                var at = motion.At(motion.TimeOfSegment(place++) + 1e-6);
                Assert.Contains(DmcFormat.Command(segment, sequence.Start), text[motion.LineOf(at.Segment) - 1], StringComparison.Ordinal);
                Assert.True(motion.TimeOfLine(motion.LineOf(at.Segment)) <= at.Seconds);
            }
        }

        Assert.Null(motion.TimeOfLine(text.Length + 1));
        Assert.Equal(motion.TimeOfSegment(0), motion.TimeOfLine(1));
    }

    [Fact]
    public void Rows_entities_and_strokes_are_found_in_time()
    {
        var (job, motion) = Motion("gasket.dxf");
        foreach (var stroke in job.Motion.Program!.Strokes)
        {
            var at = motion.At(motion.TimeOfStroke(stroke.Index)!.Value + 1e-6);
            Assert.Equal((stroke.Index, stroke.Sequences[0].Segments[0].EntityIndex, true), (at.Stroke, at.Entity, at.ToolOn));
            Assert.Equal(motion.TimeOfStroke(stroke.Index), motion.TimeOfRow(at.Row));
        }

        Assert.Equal((null, null, null), (motion.TimeOfStroke(999), motion.TimeOfEntity(-7), motion.TimeOfRow(99999)));
    }

    [Fact]
    public void A_line_is_run_by_its_trapezoid_and_with_the_tool_settled()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(10, 0, 30, 0).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        var begins = motion.TimeOfEntity(0)!.Value;
        var ramp = 20_000.0 / 256_000.0;

        Assert.Equal(new Point2D(10, 0), motion.At(begins).Position);
        Assert.Equal(20.0 * ramp / 2.0, motion.At(begins + ramp).Position.X - 10.0, precision: 9);
        Assert.Equal(10.0, motion.At(begins + (ramp / 2.0)).Speed, precision: 9);
        Assert.Equal(20.0, motion.At(begins + 0.5).Speed, precision: 9);
        Assert.Equal((true, 0.0), (motion.At(begins - 0.05).ToolOn, motion.At(begins - 0.05).Speed));
        Assert.False(motion.At(begins - 0.15).ToolOn);
        Assert.False(motion.At(motion.DurationSeconds).ToolOn);
        Assert.Equal(0, motion.LineOf(motion.At(begins).Segment));
    }

    /// <summary>A move shorter than a count has no segment: the following ones are not mistaken for it.</summary>
    [Fact]
    public void What_follows_a_move_without_a_segment_is_on_its_own_move()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Curve(CurveType.LwPolyline, Segment.FromLine(new(0, 0), new(10, 0)), Segment.FromLine(new(10, 0), new(10.0003, 0)), Segment.FromLine(new(10.0003, 0), new(20, 5)), Segment.FromLine(new(20, 5), new(30, 5))).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        Assert.Equal(4, job.Toolpath.Strokes[0].Moves.Count);

        Assert.Equal([0, 2, 3], Enumerable.Range(0, motion.SegmentCount).Select(segment => motion.At(motion.TimeOfSegment(segment) + 0.001).Move).Distinct());
    }

    /// <summary>The position in a segment determines the time: the remaining time decreases within a long segment.</summary>
    [Theory]
    [InlineData("gasket.dxf")]
    [InlineData("clock-dial.dxf")]
    public void A_place_of_a_segment_has_its_moment(string sample)
    {
        var (_, motion) = Motion(sample);
        for (var segment = 0; segment < motion.SegmentCount; segment++)
        {
            var begins = motion.TimeOfSegment(segment);
            var ends = segment + 1 < motion.SegmentCount ? motion.TimeOfSegment(segment + 1) : motion.DurationSeconds;
            foreach (var part in (double[])[0.0, 0.1, 0.3])
            {
                var at = motion.At(begins + (part * (ends - begins)));
                if (at.Segment == segment && at.Kind == MotionSpanKind.Cut) Assert.Equal(at.Seconds, motion.TimeOfPlace(segment, at.Position), tolerance: 0.01);
            }

            Assert.InRange(motion.TimeOfPlace(segment, new Point2D(1e4, -3e4)), begins, ends);
        }
    }

    [Fact]
    public void A_full_circle_begins_and_goes_on_and_never_jumps_to_its_end()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Circle(0, 0, 10).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        var begins = motion.TimeOfSegment(0);
        var start = motion.At(begins).Position;
        foreach (var aside in (double[])[-0.02, 0.0, 0.02]) Assert.Equal(begins, motion.TimeOfPlace(0, start + new Vector2D(0, aside)), tolerance: 0.05);
        var half = motion.TimeOfPlace(0, new Point2D(-start.X, -start.Y));

        Assert.Equal(begins + (Math.PI * 10.0 / 20.0), half, tolerance: 0.2);
    }

    [Fact]
    public void A_rapid_moves_each_axis_at_its_own_pace()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(50, 5, 60, 5).Build(), new DrawingSettings(), MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        var rapid = motion.Timeline.Spans.First(span => span.Kind == MotionSpanKind.Rapid);
        var middle = motion.At(rapid.Start + (rapid.Seconds / 2.0));

        Assert.Equal(25.0, middle.Position.X, tolerance: 0.1);
        Assert.Equal(5.0, middle.Position.Y, precision: 9);
        Assert.Equal((50.0, false), (Math.Round(middle.Speed, 9), middle.ToolOn));
    }

    [Fact]
    public void A_job_with_nothing_to_cut_stands_at_its_start()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Build(), new DrawingSettings { Start = new Point2D(3, 4) }, MotionStyle.Continuous);
        var motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);

        Assert.Equal((0.0, new Point2D(3, 4), -1), (motion.DurationSeconds, motion.At(1.0).Position, motion.At(1.0).Segment));
    }

    [Fact]
    public void The_speed_plot_has_the_path_length_of_the_job_and_its_corners()
    {
        var (job, motion) = Motion("paper-001.dxf");
        var exact = SpeedPlot.Sample(motion, 10_000);
        var travel = job.Sequence.PathLength;

        Assert.Equal(20.0, exact.Where(sample => sample.Cutting).Max(sample => sample.Speed), precision: 6);
        var end = job.Motion.Program!.Strokes[^1].Sequences[^1].End;
        var (x, y) = (end.X / 1000.0, end.Y / 1000.0);
        Assert.InRange(exact[^1].PathMm, travel + 50.0 + Math.Max(x, y), travel + (50.0 * Math.Sqrt(2)) + x + y + 1.0); // rapids from 0,0 to 50,50 and from the end back to 0,0
        Assert.True(exact.Zip(exact.Skip(1)).All(pair => pair.First.Seconds <= pair.Second.Seconds));
        var even = SpeedPlot.Sample(motion, 16);
        Assert.Equal(16, even.Count);
        Assert.Equal(motion.DurationSeconds, even[^1].Seconds, precision: 9);
    }

    private static (PreparedJob Job, PlannedMotion Motion) Motion(string sample)
    {
        var drawing = DrawingFile.Open(CommandTestSession.Sample(sample), new DrawingSettings(), CancellationToken.None);
        var derived = DerivedDocument.Create(new DocumentState { Drawing = drawing }, JobMode.Stream.Strategy(), CancellationToken.None);
        return (derived.Job!, derived.Motion!);
    }
}
