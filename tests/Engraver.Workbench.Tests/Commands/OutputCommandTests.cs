using Engraver.Core.Machines;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCOUTPUT depends on the effect of an output at the requested level: outputs that process material are reserved for jobs, and activating other
/// outputs requires confirmation.</summary>
public class OutputCommandTests
{
    private static readonly MachineAxes s_withZ = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) };

    private static MachineProfile Laser(bool activeLow) => MachineProfile.Default with { ToolOutput = 2, ToolActiveLow = activeLow, Spindle = new Spindle { Output = 3, IsActiveLow = activeLow } };

    private static MachineProfile Mill => MachineProfile.Default with { Axes = s_withZ, Height = new HeightDrive(), Spindle = new Spindle { Output = 3, IsActiveLow = true } };

    [Theory]
    [InlineData(false, 2, "ON")]
    [InlineData(true, 2, "OFF")]
    [InlineData(false, 3, "ON")]
    [InlineData(true, 3, "OFF")]
    public async Task What_works_on_the_material_is_not_switched_on_by_hand(bool activeLow, int output, string to)
    {
        await using var talk = await ConnectedAsync(Laser(activeLow));
        if (activeLow) Assert.Null(await talk.Session.Machine.Hand.SetOutputAsync(output, on: true, CancellationToken.None));
        var before = talk.Session.Machine.Status.Outputs;

        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCOUTPUT", $"{output}", to));

        Assert.Contains($"Output {output} controls the tool", failed.Message, StringComparison.Ordinal);
        await Assert.ThrowsAsync<InvalidOperationException>(() => talk.Session.Machine.Hand.SetOutputAsync(output, to == "ON", CancellationToken.None));
        Assert.Equal(before, talk.Session.Machine.Status.Outputs);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    public async Task An_active_low_tool_is_switched_off_by_ON_without_a_question_and_the_answer_says_what_is_on(int output)
    {
        await using var talk = await ConnectedAsync(Laser(activeLow: true));

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOUTPUT", $"{output}", "ON"));

        Assert.Equal(1 << (output - 1), talk.Session.Machine.Status.Outputs);
        Assert.Contains($"{output} is on. The connected device is off.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Where_an_axis_holds_the_tool_its_output_is_one_like_any_other_and_the_spindle_is_asked_about_when_it_begins_to_turn()
    {
        await using var talk = await ConnectedAsync(Mill);

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCOUTPUT", "1", "ON"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("Yes"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOUTPUT", "3", "ON"));
        Assert.Equal(0b101, talk.Session.Machine.Status.Outputs);

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCOUTPUT", "3", "OFF"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("No"));
        Assert.Equal(0b101, talk.Session.Machine.Status.Outputs);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOUTPUT", "3", "OFF", "Yes"));
        Assert.Equal(0b001, talk.Session.Machine.Status.Outputs);
        Assert.Contains("3 is off. The connected device is on.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOUTPUT", "1", "OFF"));
        Assert.Equal(0, talk.Session.Machine.Status.Outputs);
    }

    private static async Task<CommandTestSession> ConnectedAsync(MachineProfile profile)
    {
        var talk = CommandTestSession.WithDrawing();
        talk.Session.Document.Commit("CNCPROFILE", talk.State with { Settings = talk.State.Settings with { Machine = profile } });
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCCONNECT", "sim:?speed=max"));
        return talk;
    }
}
