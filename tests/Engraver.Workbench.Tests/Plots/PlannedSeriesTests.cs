using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Plots;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Plots;

/// <summary>The samples of the plan, compared with positions and speeds that <see cref="PlannedMotion"/> computes for single times.</summary>
public class PlannedSeriesTests
{
    [Theory]
    [InlineData("paper-001.dxf")]
    [InlineData("gasket.dxf")]
    [InlineData("nested-logo.dxf")]
    public void Speed_between_the_samples_is_that_of_the_planned_motion(string sample)
    {
        var motion = Motion(sample).Motion!;
        var series = Sample(motion);
        Assert.Equal(0.0, series.Seconds[0]);
        Assert.Equal(motion.DurationSeconds, series.Seconds[^1], 9);
        Assert.Equal(series.Seconds.Order(), series.Seconds);
        Assert.Equal(series.Path.Order(), series.Path);

        var tolerance = 0.01 * series.Of(PlotQuantity.Speed)!.Max(); // the speed of two axes that ramp at once is not linear
        for (var i = 1; i < 5000; i++)
        {
            var at = motion.At(motion.DurationSeconds * i / 5000.0);
            Assert.Equal(at.Speed * 60.0, series.ValueAt(PlotQuantity.Speed, PlotAxis.Time, at.Seconds), tolerance);
        }
    }

    [Theory]
    [InlineData("paper-001.dxf")]
    [InlineData("gasket.dxf")]
    public void Acceleration_is_the_second_derivative_of_the_planned_position(string sample)
    {
        const double Step = 1e-3;
        const double Tolerance = 0.02;
        var motion = Motion(sample).Motion!;
        var series = Sample(motion);
        var compared = 0;
        for (var i = 1; i < 4000; i++)
        {
            var seconds = motion.DurationSeconds * i / 4000.0;
            var (before, at, after) = (motion.At(seconds - Step), motion.At(seconds), motion.At(seconds + Step));
            if (before.Segment != after.Segment || before.Kind != after.Kind || IsNearJump(series, seconds, Step)) continue;
            if (at.Speed > 0.0 && (before.Speed == 0.0 || after.Speed == 0.0)) continue; // the motion begins or ends between the three
            var expected = ((after.Position - at.Position) - (at.Position - before.Position)) * (1.0 / (Step * Step));
            Assert.Equal(expected.X, series.ValueAt(PlotQuantity.AccelerationX, PlotAxis.Time, seconds), Tolerance * Math.Max(100.0, expected.Length));
            Assert.Equal(expected.Y, series.ValueAt(PlotQuantity.AccelerationY, PlotAxis.Time, seconds), Tolerance * Math.Max(100.0, expected.Length));
            compared++;
        }

        Assert.True(compared > 3000);
    }

    [Fact]
    public void The_path_is_as_long_as_cuts_and_rapids_together()
    {
        var derived = Motion("gasket.dxf");
        var series = Sample(derived.Motion!);
        var place = derived.Motion!.At(0.0).Position;
        var expected = 0.0;
        for (var i = 1; i <= 200_000; i++)
        {
            var next = derived.Motion.At(derived.Motion.DurationSeconds * i / 200_000.0).Position;
            expected += next.DistanceTo(place);
            place = next;
        }

        Assert.Equal(expected, series.Path[^1], 0.001 * expected);
        Assert.Equal(series.Seconds[^1] / 2.0, series.Convert(PlotAxis.Path, series.Convert(PlotAxis.Time, series.Seconds[^1] / 2.0, PlotAxis.Path), PlotAxis.Time), 6);
    }

    [Fact]
    public void A_limited_number_of_samples_keeps_the_peaks()
    {
        var motion = Motion("gasket.dxf").Motion!;
        var (all, few) = (Sample(motion), PlannedSeries.From(motion, null, 256, CancellationToken.None));

        Assert.InRange(few.Count, 64, 258);
        foreach (var quantity in new[] { PlotQuantity.Speed, PlotQuantity.AccelerationX }) Assert.InRange(few.Of(quantity)!.Max(Math.Abs) / all.Of(quantity)!.Max(Math.Abs), 0.9, 1.0);
        Assert.Equal(all.Of(PlotQuantity.Speed)!.Max(), few.Of(PlotQuantity.Speed)!.Max());
        Assert.Equal(few.Seconds.Order(), few.Seconds);
        Assert.Equal((all.Seconds[0], all.Seconds[^1], all.Path[^1]), (few.Seconds[0], few.Seconds[^1], few.Path[^1]));
    }

    [Fact]
    public void Over_a_serial_line_the_plan_has_the_load_of_the_line()
    {
        var derived = Motion("gasket.dxf");
        var program = derived.Job!.Motion.Program!;
        Assert.Null(Sample(derived.Motion!).Of(PlotQuantity.LinkLoad));

        MotionSeries At(int baud) => PlannedSeries.From(derived.Motion!, JobPlan.LinkLoad(program, new SerialAddress("/dev/ttyS0", baud, SerialFlow.None), JobMode.Stream.Strategy()), 100_000, CancellationToken.None);

        var (slow, fast) = (At(9600).Of(PlotQuantity.LinkLoad)!, At(19200).Of(PlotQuantity.LinkLoad)!);
        Assert.Equal(0.0, slow[0]);
        Assert.True(slow.Max() > 1.0);
        Assert.InRange(slow.Max() / fast.Max(), 1.5, 2.0); // part of the time of a command does not depend on the line
    }

    [Fact]
    public void The_spans_of_an_entity_are_where_it_is_cut()
    {
        var derived = Motion("gasket.dxf");
        var motion = derived.Motion!;
        var entities = Enumerable.Range(0, motion.SegmentCount).Select(segment => motion.At(motion.TimeOfSegment(segment) + 1e-6).Entity).Distinct().ToList();
        var total = 0.0;
        foreach (var entity in entities)
        {
            foreach (var (start, end) in motion.TimesOf([entity]))
            {
                Assert.Equal(entity, motion.At(start + ((end - start) / 2.0)).Entity);
                Assert.True(end > start);
                total += end - start;
            }
        }

        Assert.Equal(motion.Timeline.Spans.Where(span => span.Kind == MotionSpanKind.Cut).Sum(span => span.Seconds), total, 6);
        Assert.Empty(motion.TimesOf([1_000_000]));
        Assert.Empty(motion.TimesOf([]));
        Assert.Equal(total, motion.TimesOf(entities).Sum(span => span.End - span.Start), 6);
    }

    private static bool IsNearJump(MotionSeries series, double seconds, double step)
    {
        var (first, last) = (series.SampleAt(PlotAxis.Time, seconds - (2.0 * step)), Math.Min(series.SampleAt(PlotAxis.Time, seconds + (2.0 * step)) + 1, series.Count - 1));
        for (var i = first; i < last; i++)
        {
            if (series.Seconds[i + 1] - series.Seconds[i] < 1e-9 && (Differ(PlotQuantity.AccelerationX, i) || Differ(PlotQuantity.AccelerationY, i))) return true;
        }

        return false;

        bool Differ(PlotQuantity quantity, int i) => Math.Abs(series.Of(quantity)![i + 1] - series.Of(quantity)![i]) > 1.0;
    }

    private static MotionSeries Sample(PlannedMotion motion) => PlannedSeries.From(motion, null, PlannedSeries.MaxSamples, CancellationToken.None);

    private static DerivedDocument Motion(string sample)
    {
        var drawing = DrawingFile.Open(CommandTestSession.Sample(sample), new DrawingSettings(), CancellationToken.None);
        return DerivedDocument.Create(new DocumentState { Drawing = drawing }, JobMode.Stream.Strategy(), CancellationToken.None);
    }
}
