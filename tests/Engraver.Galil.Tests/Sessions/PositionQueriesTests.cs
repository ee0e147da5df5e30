using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Sessions;

/// <summary>The axes without an encoder: the controller reports them in any format of _MT (galil-dmc.md C; the number format is not known, hardware checklist
/// 7.10).</summary>
public class PositionQueriesTests
{
    private const string Refused = "?";

    [Theory]
    [InlineData(" 2.0000\r\n", "-2.5000\r\n", "AB")]
    [InlineData(" 2\r\n", "-2.5\r\n", "AB")]
    [InlineData(" 2.0\r\n", " 1.0\r\n", "A")]
    [InlineData("-1.0000\r\n", " 1.5000\r\n", "")]
    [InlineData(" 1\r\n", "-1\r\n", "")]
    public async Task Where_the_profile_names_no_motor_type_the_controller_is_asked(string a, string b, string steppers)
    {
        var place = await AskAsync(a, b, MachineAxes.Default);

        Assert.Equal((steppers, ""), (place.WithoutEncoder, place.AssumedSteppers));
        Assert.Equal(steppers.Length > 0, place.Doubt.Length > 0); // every motor is off
    }

    [Theory]
    [InlineData(null, null, "AB", "AB")]
    [InlineData(1.0, -2.0, "B", "")]
    [InlineData(1.0, null, "B", "B")]
    public async Task Where_the_controller_does_not_tell_the_profile_does_and_where_neither_does_it_counts_as_a_stepper(double? x, double? y, string steppers, string untold)
    {
        var place = await AskAsync(Refused, Refused, new MachineAxes(new MachineAxis('A', 1000.0, x), new MachineAxis('B', 1000.0, y)));

        Assert.Equal((steppers, untold), (place.WithoutEncoder, place.AssumedSteppers));
    }

    private static async Task<Core.Machines.Origins.ControllerPosition> AskAsync(string a, string b, MachineAxes axes)
    {
        var answers = new Dictionary<string, string> { ["MG _RPA,_RPB"] = " 0.0000 0.0000\r\n", ["MG _MTA"] = a, ["MG _MTB"] = b, ["MG _MOA"] = " 1.0000\r\n", ["MG _MOB"] = " 1.0000\r\n", ["TC1"] = "1 Unrecognized command\r\n" };
        var link = new ScriptedLink(line => answers.GetValueOrDefault(line, Refused) is var answer && answer == Refused ? Refused : answer + ":");
        await using var channel = new CommandChannel(link, "A", TimeSpan.FromSeconds(2), new ManualTimeProvider(), null);
        return await PositionQueries.AskAsync(channel, "AB", axes, CancellationToken.None);
    }
}
