using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Setup;

namespace Engraver.Core.Tests.Machines.Setup;

/// <summary>The letter F distinguishes the eight ways to wire two axes, and the correction makes the wiring right.</summary>
public class LetterFTests
{
    /// <summary>A machine: which axis moves the tool across and which along, and whether increasing counts move it left or to the front.</summary>
    public static TheoryData<bool, bool, bool> Wirings => new() { { false, false, false }, { false, false, true }, { false, true, false }, { false, true, true }, { true, false, false }, { true, false, true }, { true, true, false }, { true, true, true } };

    [Theory]
    [MemberData(nameof(Wirings))]
    public void Whatever_the_wiring_the_second_F_stands_as_it_should(bool isSwapped, bool isLeft, bool isFront)
    {
        var believed = new MachineAxes(new MachineAxis('A', -200.0), new MachineAxis('B', 300.0));
        var test = MachineProfile.Default with { Axes = new MachineAxes(believed.X with { CountsPerMillimetre = 1.0 }, believed.Y with { CountsPerMillimetre = 1.0 }) };
        (double Right, double Back) Seen(MachineAxes axes, int sequence)
        {
            var drawn = LetterF.Program(test, axes, 500).Strokes[0].Sequences[sequence];
            var step = drawn.End - drawn.Start; // X of the program is axis A, Y is axis B
            var (across, along) = isSwapped ? (step.Y, step.X) : (step.X, step.Y);
            return (isLeft ? -across : across, isFront ? -along : along);
        }

        static TableDirection Way((double Right, double Back) step) => Math.Abs(step.Right) > Math.Abs(step.Back) ? step.Right > 0 ? TableDirection.Right : TableDirection.Left : step.Back > 0 ? TableDirection.Back : TableDirection.Front;

        var corrected = LetterF.Corrected(believed, Way(Seen(believed, 0)), Way(Seen(believed, 1)));

        Assert.NotNull(corrected);
        Assert.Equal((TableDirection.Back, TableDirection.Right), (Way(Seen(corrected, 0)), Way(Seen(corrected, 1))));
        Assert.Equal(isSwapped ? "BA" : "AB", corrected.Letters);
        Assert.Equal(corrected, LetterF.Corrected(corrected, TableDirection.Back, TableDirection.Right)); // nothing more to correct
    }

    [Theory]
    [InlineData(TableDirection.Right, TableDirection.Left)]
    [InlineData(TableDirection.Back, TableDirection.Back)]
    public void A_long_stroke_and_bars_along_one_line_are_no_F(TableDirection longStroke, TableDirection bars) => Assert.Null(LetterF.Corrected(MachineAxes.Default, longStroke, bars));

    [Fact]
    public void It_is_ten_millimetres_high_rests_at_each_corner_and_ends_where_it_began()
    {
        var program = LetterF.Program(MachineProfile.Default, MachineAxes.FromScale(200.0, 300.0), 500);

        var ends = Assert.Single(program.Strokes).Sequences.Select(sequence => Assert.Single(sequence.Segments).End).ToList();
        Assert.Equal((1200, 3000), (ends.Max(end => end.X), ends.Max(end => end.Y)));
        Assert.Equal(default, ends[^1]);
    }

    [Fact]
    public void A_mirrored_axis_keeps_its_travel_and_its_homing_where_they_are_on_the_machine()
    {
        var axis = new MachineAxis('A', 100.0) { Travel = new AxisTravel(-5.0, 200.0), Homing = new AxisHoming { Plus = true, Zero = 200.0 } };

        var mirrored = LetterF.Mirrored(axis);

        Assert.Equal(TravelLimits.Of(axis), TravelLimits.Of(mirrored)); // in counts nothing has moved
        Assert.Equal((false, axis.Homing!.Zero * axis.CountsPerMillimetre), (mirrored.Homing!.Plus, mirrored.Homing.Zero * mirrored.CountsPerMillimetre));
        Assert.Equal(axis, LetterF.Mirrored(mirrored));
    }
}
