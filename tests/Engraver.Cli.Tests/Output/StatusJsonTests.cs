using Engraver.Cli.Output;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;

namespace Engraver.Cli.Tests.Output;

/// <summary>Output of <c>status</c>: lines, heights and an unknown work origin.</summary>
public class StatusJsonTests
{
    private static readonly MachineStatus s_ready = new()
    {
        State = MachineState.Ready,
        Controller = "DMC2143",
        Inputs = 0b101,
        Outputs = 0b010,
        MachinePosition = new Point2D(12, -7.5),
        WorkPosition = new Point2D(2, 3),
    };

    [Fact]
    public void Inputs_and_outputs_have_the_names_of_the_profile_and_no_line_is_lost_where_names_clash()
    {
        var profile = MachineProfile.Default with
        {
            Inputs = new IoLineNames([new(1, "door"), new(2, "1"), new(3, "Door")]),
            Outputs = new IoLineNames([new(2, "coolant")]),
        };
        var status = StatusJson.From(s_ready, null, profile);

        Assert.Equal((1, 0, 1), (status.Inputs["door"], status.Inputs["2"], status.Inputs["3"]));
        Assert.Equal(8, status.Inputs.Count);
        Assert.Equal((1, 0), (status.Outputs["coolant"], status.Outputs["1"]));
        Assert.DoesNotContain("2", status.Outputs.Keys);
    }

    /// <summary>As <c>StatusPoll</c> joins them, in every language.</summary>
    [Theory]
    [InlineData("")]
    [InlineData("the forward limit of axis X", "the forward limit of axis X")]
    [InlineData("the forward limit of axis X, the reverse limit of axis Y", "the forward limit of axis X", "the reverse limit of axis Y")]
    public void Each_active_limit_is_an_element(string limit, params string[] limits) => Assert.Equal(limits, StatusJson.From(s_ready with { Limit = limit }, null, MachineProfile.Default).Limits);

    [Fact]
    public void A_height_is_said_where_there_is_one()
    {
        var flat = StatusJson.From(s_ready, null, MachineProfile.Default).Text();
        Assert.Equal(["READY, DMC2143", "machine X 12 Y -7.5 mm", "work    G54 X 2 Y 3 mm"], flat);

        var high = StatusJson.From(s_ready with { MachineHeight = 20, WorkHeight = -1.25 }, null, MachineProfile.Default).Text();
        Assert.Equal(["READY, DMC2143", "machine X 12 Y -7.5 Z 20 mm", "work    G54 X 2 Y 3 Z -1.25 mm"], high);
    }

    [Fact]
    public void A_machine_without_an_origin_tells_no_place_of_the_work()
    {
        var status = StatusJson.From(s_ready with { State = MachineState.NoOrigin, OriginMissing = PreparationRules.ZeroLost.At(default, "G54"), WorkHeight = 1 }, null, MachineProfile.Default);

        Assert.Equal(new StatusJson.WorkJson("G54", null, null, null), status.Work);
        Assert.StartsWith("work    G54: unknown. The controller was switched off", status.Text().Last(), StringComparison.Ordinal);
        Assert.Contains("engraver zero", status.Text().Last(), StringComparison.Ordinal);
        Assert.DoesNotContain("CNC", status.Text().Last(), StringComparison.Ordinal);
    }
}
