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
    [InlineData(30001, 0, "Axis A: 30.001 of -1 to 30")]
    [InlineData(0, 1, "Axis C: -0.002 of 0 to 20.001")]
    [InlineData(0, -10001, "Axis C: 20.002 of 0 to 20.001")]
    public void A_place_outside_is_refused_with_axis_place_and_travel(int x, int y, string? facts) =>
        Assert.Equal(facts, TravelLimits.Refusal(Profile(), new CountsPoint(x, y)) is { Facts: var f } ? $"Axis {f[0]}: {f[1]} of {f[2]} to {f[3]}" : null);

    [Fact]
    public void The_extents_of_a_job_hold_the_bulge_of_its_arcs_its_way_there_and_its_finish()
    {
        // From 1000,0 half a turn counter-clockwise round 0,0: highest at 0,1000.
        var arc = new VectorSegment(VectorSegmentKind.Arc, new CountsPoint(-1000, 0), 1000, 0.0, 180.0, 0, 3141.6);
        var line = new VectorSegment(VectorSegmentKind.Line, new CountsPoint(-1000, -70), 0, 0, 0, 0, 70);
        var program = new MotionProgram(Profile(), new CountsPoint(-5, 3), [new MotionStroke(0, new CountsPoint(1000, 0), [new VectorSequence(new CountsPoint(1000, 0), 1000, [arc, line])])]);

        Assert.Equal(new MotionExtents(-1000, -70, 1000, 1000), MotionExtents.Of(program));
        Assert.Equal(new MotionExtents(-1000, -70, 2000, 1000), MotionExtents.Of(program with { Finish = new CountsPoint(2000, 0) }));
        var clockwise = program with { Strokes = [new MotionStroke(0, new CountsPoint(1000, 0), [new VectorSequence(new CountsPoint(1000, 0), 1000, [arc with { DeltaDegrees = -180.0 }])])] };
        Assert.Equal(-1000, MotionExtents.Of(clockwise).LeastY);
    }

    [Fact]
    public void A_job_is_refused_where_it_is_placed()
    {
        var line = new VectorSegment(VectorSegmentKind.Line, new CountsPoint(5000, 0), 0, 0, 0, 0, 5000);
        var program = new MotionProgram(Profile(), default, [new MotionStroke(0, default, [new VectorSequence(default, 1000, [line])])]);
        PlacementResult At(int x) => WorkPlacement.Within(new PlacementResult(new CountsPoint(x, 0), OriginSource.Given, null), program, MachineMemory.Empty, new ControllerPlace(default));

        Assert.NotNull(At(25000).Frame);
        Assert.Equal((null, "JOB0030"), (At(25001).Frame, At(25001).Refusal?.Id));
    }

    [Fact]
    public void Without_homing_the_travel_counts_from_the_controllers_zero_and_with_it_from_where_it_was_homed()
    {
        var homing = Profile() with { Axes = Profile().Axes with { X = Profile().Axes.X with { Homing = new AxisHoming() } } };
        var place = new ControllerPlace(default, Mark: 7);
        var homed = MachineMemory.Empty with { Mark = 7, HomedAs = homing.HomedAs };

        Assert.True(MachineMemory.Empty.KnowsTravel(Profile(), place));
        Assert.False(MachineMemory.Empty.KnowsTravel(Profile(), place with { Doubt = "the motor is off" }));
        Assert.False(MachineMemory.Empty.KnowsTravel(homing, place));
        Assert.True(homed.KnowsTravel(homing, place));
        Assert.False(homed.KnowsTravel(homing, place with { Mark = 8 }));
        Assert.False((homed with { Lost = "it slipped" }).KnowsTravel(homing, place));
    }
}
