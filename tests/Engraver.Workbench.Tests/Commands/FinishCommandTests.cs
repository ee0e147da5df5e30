using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCFINISH is one setting for the plan, the playback and the run: the machine ends at the planned position.</summary>
public class FinishCommandTests
{
    [Theory]
    [InlineData("Origin", 0.0, 0.0)]
    [InlineData("Stay", 50.0, 50.0)]
    [InlineData("Park", -8.0, 3.0)]
    public async Task The_machine_ends_where_the_setting_says(string place, double x, double y)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:");
        var state = talk.Session.Document.Current;
        talk.Session.Document.Commit("PROFILE", state with { Settings = state.Settings with { Machine = MachineProfile.Default with { ParkX = -8.0, ParkY = 3.0 } } });

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCFINISH", place));
        await talk.TypeAsync("CNCARM", "Stream", "CNCRUN");

        Assert.Equal(JobOutcome.Complete, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Equal((x, y), (talk.Session.Machine.Status.MachinePosition!.Value.X, talk.Session.Machine.Status.MachinePosition!.Value.Y));
        var planned = (await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None)).Motion!;
        if (place != "Park") Assert.Equal(x, planned.At(planned.DurationSeconds).Position.X, 9); // The park position is a machine position.
        await talk.TypeAsync("U", "U");
        Assert.Equal(FinishPlace.Origin, talk.Session.Document.Current.Settings.Finish);
    }

    [Fact]
    public async Task A_machine_without_a_park_position_does_not_park()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));

        Assert.Contains("parkX", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCFINISH", "Park")).Message, StringComparison.Ordinal);
        Assert.Equal(FinishPlace.Origin, talk.Session.Document.Current.Settings.Finish);
    }
}
