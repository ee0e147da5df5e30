using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs.Generation;

public class MotionProgramGeneratorTests
{
    private const double MaxError = 0.001;

    [Fact]
    public void Counts_are_rounded_half_away_from_zero()
    {
        var scale = CountsScale.From(1000.0, -1000.0);

        Assert.Equal(new CountsPoint(1, 1), scale.ToCounts(new Point2D(0.0005, -0.0005)));
        Assert.Equal(new CountsPoint(-1, -1), scale.ToCounts(new Point2D(-0.0005, 0.0005)));
    }

    [Fact]
    public void End_points_are_rounded_not_increments()
    {
        var thirds = Enumerable.Range(0, 3000).Select(i => Toolpaths.Line(i / 3.0, 0, (i + 1) / 3.0, 0)).ToArray();

        Assert.Equal(new CountsPoint(1_000_000, 0), Only(Program(Toolpaths.OfStroke(thirds))).Sequences[^1].End);
    }

    [Fact]
    public void The_papers_part_becomes_two_corners_and_one_arc_with_the_numbers_of_the_drawing()
    {
        var stroke = Only(Program(Toolpaths.Paper));

        Assert.Equal(new CountsPoint(50_000, 50_000), stroke.Start);
        Assert.Equal(["VP 100000,0"], Commands(stroke.Sequences[0]));
        Assert.Equal(["VP 0,100000", "CR 50000,0,180", "VP -100000,0"], Commands(stroke.Sequences[1]));
        Assert.Equal([1, 2, 3], stroke.Sequences[1].Segments.Select(segment => segment.EntityIndex));
        Assert.Equal(20_000, stroke.Sequences[1].Speed);
    }

    [Theory]
    [InlineData(-1, 1, "CR 10000,150,-90")]
    [InlineData(1, -1, "CR 10000,330,-90")]
    [InlineData(-1, -1, "CR 10000,210,90")]
    public void Mirrored_axes_turn_the_angles_and_the_sense(int x, int y, string command)
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(1000 * x, 1000 * y) };

        Assert.Equal([command], Commands(Only(Program(Toolpaths.OfStroke(Toolpaths.Arc(0, 0, 10, 30, 90)), profile)).Sequences[0]));
    }

    /// <summary>50 m at 1000 counts per mm is beyond CR (galil-dmc.md F.5): 350 degrees of it are about 24,000 chords.</summary>
    [Fact]
    public void Arcs_that_need_more_chords_than_any_job_can_use_are_refused_before_a_chord_is_made()
    {
        var arcs = Enumerable.Range(0, 10_000).Select(i => new[] { Toolpaths.Arc(i % 100, i / 100, i == 77 ? 60_000 : 50_000, 0, 350) }).ToArray();

        var made = MotionProgramGenerator.Generate(Toolpaths.OfStrokes(arcs), MachineProfile.Default, new(MaxError, 0.0), entity => new SourceRef(entity));

        Assert.Null(made.Program);
        var finding = Assert.Single(made.Diagnostics);
        Assert.Equal(("MOT0012", 77), (finding.Id, finding.Source.Line));
        Assert.Contains("a radius of 60000 mm", finding.Message, StringComparison.Ordinal);
        Assert.Contains("a radius of up to 6000 mm", finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_few_arcs_beyond_the_controllers_radius_are_cut_as_chords()
    {
        var arcs = Enumerable.Range(0, 10).Select(i => new[] { Toolpaths.Arc(i, 0, 50_000, 0, 90) }).ToArray();

        Assert.All(Program(Toolpaths.OfStrokes(arcs)).Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments), segment => Assert.Equal(VectorSegmentKind.Line, segment.Kind));
    }

    [Theory]
    [InlineData(9.0, 1)]
    [InlineData(10.0, 1)]
    [InlineData(11.0, 2)]
    [InlineData(-11.0, 2)]
    public void Without_rounding_the_machine_stops_only_where_the_path_turns_by_more_than_ten_degrees(double turn, int sequences)
    {
        Assert.Equal(sequences, Only(Program(Bend(turn))).Sequences.Count);
    }

    /// <summary>The largest arc within 10 counts of the corner has the radius t cos(turn / 2) / (1 - cos(turn / 2)); it is passed at v2/r = A.</summary>
    [Theory]
    [InlineData(90.0, 24)]
    [InlineData(-90.0, 24)]
    [InlineData(120.0, 10)]
    [InlineData(30.0, 283)]
    public void A_corner_is_rounded_by_the_largest_arc_within_the_tolerance(double turn, int radius)
    {
        var sequence = Assert.Single(Only(Program(Bend(turn), corner: 0.01)).Sequences);

        var arc = Assert.Single(sequence.Segments, segment => segment.Kind == VectorSegmentKind.Arc);
        Assert.Equal(radius, arc.Radius);
        Assert.Equal(turn, arc.DeltaDegrees, 0.5); // its ends are whole counts
        Assert.InRange(sequence.SpeedOf(arc), Math.Sqrt(256000.0 * radius) - 2.0, Math.Sqrt(256000.0 * radius));
        Assert.InRange(Distance(sequence, new CountsPoint(10000, 0)), 8.0, 11.0);
    }

    /// <summary>The jump of velocity 2 v sin(turn / 2) takes one sample at the acceleration.</summary>
    [Theory]
    [InlineData(150.0)]
    [InlineData(-150.0)]
    public void A_corner_that_no_arc_of_ten_counts_rounds_is_passed_slowly(double turn)
    {
        var sequence = Assert.Single(Only(Program(Bend(turn), corner: 0.01)).Sequences);

        Assert.DoesNotContain(sequence.Segments, segment => segment.Kind == VectorSegmentKind.Arc);
        var braking = Assert.Single(sequence.Segments, segment => segment.End == new CountsPoint(10000, 0));
        Assert.InRange(sequence.SpeedOf(braking), 100, (int)(256.0 / (2.0 * Math.Sin(75.0 * Math.PI / 180.0))));
    }

    [Fact]
    public void A_turn_that_the_feed_allows_is_left_as_it_is()
    {
        var sequence = Assert.Single(Only(Program(Bend(0.7), corner: 0.01)).Sequences);

        Assert.Equal((2, 20000, false), (sequence.Segments.Count, sequence.Speed, sequence.HasOwnSpeeds));
    }

    /// <summary>Arcs of neighbouring corners share the side between them.</summary>
    [Fact]
    public void The_arcs_of_a_short_side_do_not_overlap()
    {
        var stroke = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10, 0, 10.02, 0.02), Toolpaths.Line(10.02, 0.02, 20, 0.02));

        var sequence = Assert.Single(Only(Program(stroke, corner: 0.01)).Sequences);

        var arcs = sequence.Segments.Where(segment => segment.Kind == VectorSegmentKind.Arc).ToList();
        Assert.Equal(2, arcs.Count);
        Assert.All(arcs, arc => Assert.InRange(arc.Radius, 25, 34)); // half a side of 28.3 counts is the tangent length of 34
        Assert.All(sequence.Segments, segment => Assert.InRange(segment.End.Y, 0, 20));
    }

    /// <summary>A line into an arc, and two arcs: the rounding arc is tangent to both.</summary>
    [Fact]
    public void Corners_at_arcs_are_rounded_too()
    {
        var stroke = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Arc(15, 0, 5, 180, -90), Toolpaths.Arc(10, 5, 5, 0, 90));

        var sequence = Assert.Single(Only(Program(stroke, corner: 0.01)).Sequences);

        var (from, last) = (sequence.Start, default(Vector2D));
        foreach (var segment in sequence.Segments)
        {
            var (start, end) = (SequenceKinematics.Direction(segment, from, 0.0), SequenceKinematics.Direction(segment, from, 1.0));
            if (last != default) Assert.InRange(Math.Abs(last.TurnTo(start).Degrees), 0.0, 4.0);
            (from, last) = (segment.End, end);
        }

        Assert.True(sequence.Segments.Count(segment => segment.Kind == VectorSegmentKind.Arc) >= 4);
    }

    [Fact]
    public void Nothing_is_rounded_with_unequal_scales_or_for_calls()
    {
        var unequal = MachineProfile.Default with { Axes = MachineAxes.FromScale(1000, 500) };

        Assert.All(Only(Program(Bend(90), unequal, corner: 0.01)).Sequences[0].Segments, segment => Assert.Equal(VectorSegmentKind.Line, segment.Kind));
        Assert.Equal(2, Only(MotionProgramGenerator.Generate(Bend(90), MachineProfile.Default, new(MaxError, 0.01), null, MotionStyle.Calls).Program!).Sequences.Count);
    }

    /// <summary>A circle of 0.1 mm: VA and the speed share the acceleration.</summary>
    [Fact]
    public void An_arc_is_run_within_the_total_acceleration()
    {
        var sequence = Only(Program(Toolpaths.OfStroke(Toolpaths.Arc(0, 0, 0.1, 0, 360)))).Sequences[0];

        Assert.InRange(double.Hypot(sequence.Acceleration!.Value, (double)sequence.Speed * sequence.Speed / 100.0), 0.99 * 256000, 256000);
    }

    private static Toolpath Bend(double turn)
    {
        var (cos, sin) = (Math.Cos(turn * Math.PI / 180.0), Math.Sin(turn * Math.PI / 180.0));
        return Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10, 0, 10 + (10 * cos), 10 * sin));
    }

    private static double Distance(VectorSequence sequence, CountsPoint place)
    {
        var (from, nearest) = (sequence.Start, double.PositiveInfinity);
        foreach (var segment in sequence.Segments)
        {
            nearest = Math.Min(nearest, new SegmentPath(from, segment).DistanceTo(new Point2D(place.X, place.Y)));
            from = segment.End;
        }

        return nearest;
    }

    [Fact]
    public void A_speck_of_another_direction_inside_a_straight_is_no_corner()
    {
        var stroke = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10, 0, 10, 0.0004), Toolpaths.Line(10, 0.0004, 20, 0.0004));

        Assert.Equal(["VP 10000,0", "VP 20000,0"], Commands(Assert.Single(Only(Program(stroke)).Sequences)));
    }

    [Fact]
    public void A_corner_with_a_vanishing_chamfer_is_a_corner()
    {
        var stroke = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10, 0, 10.0003, 0.0003), Toolpaths.Line(10.0003, 0.0003, 10.0003, 10));

        Assert.Equal(2, Only(Program(stroke)).Sequences.Count);
    }

    [Fact]
    public void Many_moves_below_a_count_are_cut_when_they_add_up_to_counts()
    {
        var crawl = Toolpaths.OfStroke([.. Enumerable.Range(0, 100).Select(i => Toolpaths.Line(i * 0.0003, 0, (i + 1) * 0.0003, 0))]);

        Assert.Equal(new CountsPoint(30, 0), Only(Program(crawl)).Sequences[^1].End);
    }

    [Fact]
    public void A_gap_within_the_join_tolerance_is_cut_across()
    {
        var stroke = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10.004, 0, 20, 0));

        Assert.Equal(["VP 10000,0", "VP 10004,0", "VP 20000,0"], Commands(Only(Program(stroke)).Sequences[0]));
    }

    [Fact]
    public void A_line_longer_than_the_controller_takes_is_split_evenly()
    {
        var stroke = Only(Program(Toolpaths.OfStroke(Toolpaths.Line(0, 0, 20_000, 0))));

        Assert.Equal(3, stroke.Sequences[0].Segments.Count);
        Assert.All(stroke.Sequences[0].Segments, segment => Assert.InRange(segment.Length, 1, 8_000_000));
        Assert.Equal(new CountsPoint(20_000_000, 0), stroke.Sequences[0].End);
    }

    [Fact]
    public void A_path_longer_than_a_sequence_may_be_is_broken_into_sequences()
    {
        var toAndFro = Toolpaths.OfStroke([.. Enumerable.Range(0, 500).Select(i => Toolpaths.Line(4000 * (i % 2), 0, 4000 * ((i + 1) % 2), 0))]);
        var profile = MachineProfile.Default;

        var sequences = Only(Program(toAndFro, profile, corner: 1e-6)).Sequences;

        Assert.Equal(2, sequences.Count);
        Assert.All(sequences, sequence => Assert.True(sequence.Length < 2e9));
    }

    [Theory]
    [InlineData(0.009, "below ten counts")]
    [InlineData(6001.0, "above six million counts")]
    public void An_arc_whose_radius_CR_does_not_take_is_cut_as_chords_within_the_error(double radius, string why)
    {
        var arc = Toolpaths.Arc(0, 0, radius, 10, 25);
        var stroke = Only(Program(Toolpaths.OfStroke(arc)));

        Assert.All(stroke.Sequences[0].Segments, segment => Assert.True(segment.Kind == VectorSegmentKind.Line, why));
        Assert.InRange(WorstOff(stroke, place => arc.DistanceTo(new Point2D(place.X / 1000, place.Y / 1000))), 0.0, MaxError + 0.00071);
    }

    [Fact]
    public void With_unequal_axes_arcs_are_chords_within_the_error_and_a_note_says_so()
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(1000, -400) };
        var arc = Toolpaths.Arc(3, 4, 25, 10, 300);
        var generation = MotionProgramGenerator.Generate(Toolpaths.OfStroke(arc), profile, new(MaxError, 0.0), null);

        Assert.Equal(["MOT0005"], generation.Diagnostics.Select(finding => finding.Id));
        var stroke = Only(generation.Program!);
        Assert.All(stroke.Sequences[0].Segments, segment => Assert.Equal(VectorSegmentKind.Line, segment.Kind));
        Assert.InRange(WorstOff(stroke, place => arc.DistanceTo(new Point2D(place.X / 1000, place.Y / -400))), 0.0, MaxError + 0.00136);
    }

    [Fact]
    public void Segments_that_the_buffer_could_not_be_fed_with_slow_the_sequence_down()
    {
        var profile = MachineProfile.Default;
        var fine = Toolpaths.OfStroke([.. Enumerable.Range(0, 1000).Select(i => Toolpaths.Line(i * 0.02, 0, (i + 1) * 0.02, 0))]);
        var shortFine = Toolpaths.OfStroke([.. Enumerable.Range(0, 400).Select(i => Toolpaths.Line(i * 0.02, 0, (i + 1) * 0.02, 0))]);

        Assert.Equal(8_818, Only(Program(fine, profile)).Sequences[0].Speed);
        Assert.Equal(20_000, Only(Program(shortFine, profile)).Sequences[0].Speed);
        var finding = Assert.Single(MotionProgramGenerator.Generate(fine, profile, new(MaxError, 0.0), entity => new SourceRef(70 + entity)).Diagnostics);
        Assert.Equal(("MOT0027", "1200", "1000", "441", "1", "529.1"), (finding.Id, finding.Facts[0], finding.Facts[1], finding.Facts[2], finding.Facts[3], finding.Facts[4]));
        Assert.Empty(MotionProgramGenerator.Generate(shortFine, profile, new(MaxError, 0.0), null).Diagnostics);
        Assert.Empty(MotionProgramGenerator.Generate(fine, profile, new(MaxError, 0.0) { FitsArcs = true }, null).Diagnostics);
    }

    [Fact]
    public void Calls_stop_after_every_segment_and_aim_the_next_from_whole_counts()
    {
        var stroke = Only(MotionProgramGenerator.Generate(Toolpaths.Paper, MachineProfile.Default, new(MaxError, 0.0), null, MotionStyle.Calls).Program!);

        Assert.Equal([1, 1, 1, 1], stroke.Sequences.Select(sequence => sequence.Segments.Count));
        Assert.Equal(stroke.Sequences.Skip(1).Select(sequence => sequence.Start), stroke.Sequences.SkipLast(1).Select(sequence => sequence.End));
    }

    [Fact]
    public void A_stroke_smaller_than_a_count_is_left_out_and_named()
    {
        var speck = Toolpaths.OfStrokes([Toolpaths.Arc(5, 5, 0.0001, 0, 360)], [Toolpaths.Line(0, 0, 1, 0)]);
        var generation = MotionProgramGenerator.Generate(speck, MachineProfile.Default, new(MaxError, 0.0), entity => new SourceRef(70 + entity));

        Assert.Equal([("MOT0004", 70L)], generation.Diagnostics.Select(finding => (finding.Id, finding.Source.Line)));
        Assert.Equal(1, Only(generation.Program!).Index);
    }

    [Theory]
    [InlineData(3e6, "MOT0001")]
    [InlineData(-2147484.0, "MOT0001")]
    [InlineData(double.NaN, "MOT0002")]
    [InlineData(double.PositiveInfinity, "MOT0002")]
    public void An_entity_that_cannot_be_counted_is_named_and_there_is_no_program(double x, string id)
    {
        var toolpath = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 1, 1), Toolpaths.Line(1, 1, x, 1));
        var generation = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(MaxError, 0.0), entity => new SourceRef(100 + entity, "2F"));

        Assert.Null(generation.Program);
        Assert.Equal((id, new SourceRef(101, "2F")), (generation.Diagnostics[0].Id, generation.Diagnostics[0].Source));
    }

    /// <summary>A controller counts from the present position of the machine, which is the start.</summary>
    [Fact]
    public void What_lies_near_the_start_is_counted_however_far_both_lie_from_the_drawings_zero()
    {
        var toolpath = Toolpaths.OfStroke(Toolpaths.Line(3_500_000, 5_400_000, 3_500_060, 5_400_000), Toolpaths.Arc(3_500_060, 5_400_020, 20, -90, 180)) with { ToolStart = new Point2D(3_500_000, 5_400_000) };
        var program = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(MaxError, 0.0), null).Program!;

        Assert.Equal(new CountsPoint(3_500_000_000, 5_400_000_000), program.Start);
        Assert.Equal(new CountsPoint(3_500_060_000, 5_400_040_000), program.Strokes[^1].Sequences[^1].End);
        Assert.Equal(["VP 60000,0", "CR 20000,270,180"], program.Strokes[0].Sequences.SelectMany(sequence => DmcFormat.Commands(sequence, program.Profile.Axes)));
    }

    [Fact]
    public void An_arc_that_bulges_out_of_the_counts_is_refused_though_its_ends_are_inside() =>
        Assert.Equal("MOT0001", MotionProgramGenerator.Generate(Toolpaths.OfStroke(Toolpaths.Arc(2_147_400, 0, 200, -90, 180)), MachineProfile.Default, new(MaxError, 0.0), null).Diagnostics[0].Id);

    [Fact]
    public void A_tool_start_that_cannot_be_counted_is_refused() =>
        Assert.Equal("MOT0003", MotionProgramGenerator.Generate(Toolpaths.Paper with { ToolStart = new Point2D(0, double.NaN) }, MachineProfile.Default, new(MaxError, 0.0), null).Diagnostics[0].Id);

    [Fact]
    public void A_profile_beyond_the_controller_gives_no_program() =>
        Assert.Equal("MOT0006", MotionProgramGenerator.Generate(Toolpaths.Paper, MachineProfile.Default with { AccelerationCounts = 100_000 }, new(MaxError, 0.0), null).Diagnostics[0].Id);

    [Fact]
    public void An_empty_toolpath_is_an_empty_program() =>
        Assert.Empty(Program(new Toolpath(new Point2D(1, 2), [])).Strokes);

    private static MotionProgram Program(Toolpath toolpath, MachineProfile? profile = null, double corner = 0.0) =>
        MotionProgramGenerator.Generate(toolpath, profile ?? MachineProfile.Default, new(MaxError, corner), null).Program ?? throw new InvalidOperationException("The toolpath should be good.");

    private static MotionStroke Only(MotionProgram program) => Assert.Single(program.Strokes);

    private static IEnumerable<string> Commands(VectorSequence sequence) => sequence.Segments.Select(segment => DmcFormat.Command(segment, sequence.Start));

    private static double WorstOff(MotionStroke stroke, Func<Point2D, double> off)
    {
        var replay = new SegmentReplay(MachineProfile.Default.AngleQuantumDegrees);
        foreach (var sequence in stroke.Sequences) replay.Run(sequence);
        return replay.Track.Max(at => off(at.Place));
    }
}
