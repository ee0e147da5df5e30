using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;

namespace Engraver.Core.Tests.Machines;

public class TravelLimitsTests
{
    private static MachineProfile Profile(double scaleX = 1000, double scaleY = -500) => MachineProfile.Default with
    {
        Axes = new MachineAxes(new MachineAxis('A', scaleX) { Travel = new AxisTravel(-1, 30) }, new MachineAxis('C', scaleY) { Travel = new AxisTravel(0, 20.0005) }),
    };

    [Fact]
    public void The_ends_in_counts_lie_inside_the_millimetres_and_a_mirrored_axis_turns_them_round()
    {
        Assert.Equal([new SoftLimit('A', -1000, 30000), new SoftLimit('C', -10000, 0)], TravelLimits.Of(Profile()));
        Assert.Empty(TravelLimits.Of(MachineProfile.Default));
    }

    [Theory]
    [InlineData(30000, 0, null)]
    [InlineData(-1000, -10000, null)]
    [InlineData(30001, 0, "Axis X: 30.001 of -1 to 30")]
    [InlineData(0, 1, "Axis Y: -0.002 of 0 to 20.001")]
    [InlineData(0, -10001, "Axis Y: 20.002 of 0 to 20.001")]
    public void A_place_outside_is_refused_with_axis_place_and_travel(int x, int y, string? facts) =>
        Assert.Equal(facts, TravelLimits.Refusal(Profile(), new CountsPoint(x, y)) is { Facts: var f } ? $"Axis {f[0]}: {f[1]} of {f[2]} to {f[3]}" : null);

    [Fact]
    public void The_extents_of_a_job_hold_the_bulge_of_its_arcs_its_way_there_and_its_finish()
    {
        // From 1000,0 half a turn counter-clockwise around 0,0: highest at 0,1000.
        var arc = new VectorSegment(VectorSegmentKind.Arc, new CountsPoint(-1000, 0), 1000, 0.0, 180.0, 0, 3141.6);
        var line = new VectorSegment(VectorSegmentKind.Line, new CountsPoint(-1000, -70), 0, 0, 0, 0, 70);
        var program = new MotionProgram(Profile(), new CountsPoint(-5, 3), [new MotionStroke(0, new CountsPoint(1000, 0), [new VectorSequence(new CountsPoint(1000, 0), 1000, [arc, line])])]);

        Assert.Equal(new MotionExtents(-1000, -70, 1000, 1000, new CountsRange(0, 0)), MotionExtents.Of(program));
        Assert.Equal(new MotionExtents(-1000, -70, 2000, 1000, new CountsRange(0, 0)), MotionExtents.Of(program with { Finish = new CountsPoint(2000, 0) }));
        var clockwise = program with { Strokes = [new MotionStroke(0, new CountsPoint(1000, 0), [new VectorSequence(new CountsPoint(1000, 0), 1000, [arc with { DeltaDegrees = -180.0 }])])] };
        Assert.Equal(-1000, MotionExtents.Of(clockwise).MinY);
    }

    /// <summary>Cuts from 0.5 to 2 mm deep under rapids at 5 mm, on an axis that counts upwards or downwards.</summary>
    [Theory]
    [InlineData(100, false, -200, 500)]
    [InlineData(100, true, 500, 1200)]
    [InlineData(-100, false, -500, 200)]
    [InlineData(-100, true, -1200, -500)]
    public void The_heights_of_a_job_reach_from_its_deepest_cut_to_its_clearance_and_a_dry_run_is_lifted_by_both(double scaleZ, bool dryRun, long least, long most)
    {
        var program = Slope(Mill(scaleZ));

        Assert.Equal(new CountsRange(least, most), MotionExtents.Of(program).Heights(program.Profile, dryRun));
        Assert.Equal(700 * Math.Sign(scaleZ), DryRunLift.Of(program));
        var drawn = program with { Profile = program.Profile with { Height = null } };
        Assert.Null(MotionExtents.Of(drawn).Heights(drawn.Profile, dryRun)); // the tool is an output: the height is unchanged
        Assert.Equal(0, DryRunLift.Of(drawn));
        Assert.Null(MotionExtents.Of(program with { Strokes = [] }).Heights(program.Profile, dryRun));
    }

    /// <summary>The travel is -1 to 8 mm; the job reaches from -2 to 5 mm over the work, a dry run from 5 to 12.</summary>
    [Theory]
    [InlineData(1, false, null)]
    [InlineData(3, false, null)]
    [InlineData(0.99, false, "JOB0033 Z -1.01 -1 8")]
    [InlineData(3.01, false, "JOB0033 Z 8.01 -1 8")]
    [InlineData(-4, true, null)]
    [InlineData(-6, true, null)]
    [InlineData(-3.99, true, "JOB0034 7 Z 8.01 -1 8")]
    [InlineData(-6.01, true, "JOB0034 7 Z -1.01 -1 8")]
    public void A_job_whose_tool_would_leave_its_travel_is_refused_by_the_height_of_the_work_and_a_dry_run_by_its_own(double work, bool dryRun, string? said)
    {
        foreach (var scaleZ in (double[])[100, -100])
        {
            var frame = new CountsPoint(0, 0, (int)Math.Round(work * scaleZ));
            var program = Slope(Mill(scaleZ));
            var refused = TravelLimits.Refusal(program.Profile, program, frame, dryRun);
            Assert.Equal(said, refused is null ? null : $"{refused.Id} {string.Join(' ', refused.Facts)}");
            var found = WorkPlacement.Within(new PlacementResult(frame, OriginSource.Given, null), program, dryRun, StoredMachineState.Empty, new ControllerPosition(default));
            Assert.Equal((said?[..7], said is null, said is null), (found.Refusal?.Id, found.Frame is not null, found.IsWithinTravel));
        }
    }

    [Fact]
    public void Where_nobody_knows_the_travel_nothing_was_held_against_it()
    {
        var found = WorkPlacement.Within(new PlacementResult(default(CountsPoint), OriginSource.Here, null), Slope(Mill(100)), dryRun: false, StoredMachineState.Empty with { Lost = "it slipped" }, new ControllerPosition(default));

        Assert.Equal((true, false), (found.Frame is not null, found.IsWithinTravel));
    }

    private static MachineProfile Mill(double scaleZ) => MachineProfile.Default with
    {
        Axes = MachineProfile.Default.Axes with { Z = new MachineAxis('C', scaleZ) { Travel = new AxisTravel(-1, 8) } },
        Height = new HeightDrive { ClearanceHeight = 5.0 },
    };

    private static MotionProgram Slope(MachineProfile mill)
    {
        CountsPoint At(int x, double height) => new(x, 0, mill.Scale.ToHeight(height));
        var line = new VectorSegment(VectorSegmentKind.Line, At(1000, -2), 0, 0, 0, 0, 1011);
        return new MotionProgram(mill, default, [new MotionStroke(0, At(0, -0.5), [new VectorSequence(At(0, -0.5), 1000, [line])])]);
    }

    [Fact]
    public void A_job_is_refused_where_it_is_placed()
    {
        var line = new VectorSegment(VectorSegmentKind.Line, new CountsPoint(5000, 0), 0, 0, 0, 0, 5000);
        var program = new MotionProgram(Profile(), default, [new MotionStroke(0, default, [new VectorSequence(default, 1000, [line])])]);
        PlacementResult At(int x) => WorkPlacement.Within(new PlacementResult(new CountsPoint(x, 0), OriginSource.Given, null), program, dryRun: false, StoredMachineState.Empty, new ControllerPosition(default));

        Assert.NotNull(At(25000).Frame);
        Assert.Equal((null, "JOB0030"), (At(25001).Frame, At(25001).Refusal?.Id));
    }

    [Fact]
    public void Without_homing_the_travel_counts_from_the_controllers_zero_and_with_it_from_where_it_was_homed()
    {
        var homing = Profile() with { Axes = Profile().Axes with { X = Profile().Axes.X with { Homing = new AxisHoming() } } };
        var place = new ControllerPosition(default, Mark: 7);
        var homed = StoredMachineState.Empty with { Mark = 7, HomedAs = homing.HomedAs };

        Assert.True(StoredMachineState.Empty.IsTravelKnown(Profile(), place));
        Assert.False(StoredMachineState.Empty.IsTravelKnown(Profile(), place with { Doubt = "the motor is off" }));
        Assert.False(StoredMachineState.Empty.IsTravelKnown(homing, place));
        Assert.True(homed.IsTravelKnown(homing, place));
        Assert.False(homed.IsTravelKnown(homing, place with { Mark = 8 }));
        Assert.False((homed with { Lost = "it slipped" }).IsTravelKnown(homing, place));
    }
}
