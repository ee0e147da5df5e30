using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs.Hand;

/// <summary><c>engraver status</c>, <c>motors</c>, <c>goto</c> and <c>home</c>: one poll or one action, and then the status.</summary>
internal sealed class HandVerbs
{
    /// <summary>Positions that have a name.</summary>
    private const string Park = "park";
    private const string Clearance = "clearance";

    private readonly VerbHost _host;
    private readonly MachineAction _action;

    private HandVerbs(VerbHost host) => (_host, _action) = (host, new MachineAction(host));

    public static Command Status(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var command = verb._action.Command("status", Wording.Get("Hand.Status"));
        command.SetAction((parsed, stop) => verb._action.RunAsync(parsed, (_, _) => Task.FromResult(ExitCode.Done), stop));
        return command;
    }

    public static Command Motors(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var state = new Argument<string>("ON|OFF") { Description = Wording.Get("Hand.MotorsState") };
        state.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && !token.Value.Equals("on", StringComparison.OrdinalIgnoreCase) && !token.Value.Equals("off", StringComparison.OrdinalIgnoreCase)) result.AddError(Wording.Get("Hand.InvalidMotorsState", token.Value));
        });
        var command = verb._action.Command("motors", Wording.Get("Hand.Motors"));
        command.Arguments.Add(state);
        command.SetAction((parsed, stop) => verb._action.RunAsync(parsed, (machine, cancellation) => verb.SwitchAsync(machine, parsed.GetValue(state)!.Equals("on", StringComparison.OrdinalIgnoreCase), cancellation), stop));
        return command;
    }

    private async Task<int> SwitchAsync(MachineSession machine, bool on, CancellationToken stop)
    {
        if (await machine.Hand.SetMotorsAsync(on, stop).ConfigureAwait(false) is not { } refused) return ExitCode.Done;
        _host.Error.WriteLine($"engraver: {refused.Message}");
        return ExitCode.Refused;
    }

    public static Command GoTo(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var place = new Argument<string?>("X,Y|park|clearance") { Description = Wording.Get("Hand.Target") };
        place.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && token.Value is not (Park or Clearance) && PlacementOptions.TryParsePosition(token.Value) is null) result.AddError(Wording.Get("Hand.InvalidTarget", token.Value));
        });
        var byMachine = new Option<bool>("--machine-position") { Description = Wording.Get("Hand.ByMachinePosition") };
        var command = verb._action.Command("goto", Wording.Get("Hand.GoTo"));
        command.Arguments.Add(place);
        command.Options.Add(byMachine);
        command.SetAction((parsed, stop) => verb._action.RunAsync(
            parsed,
            (machine, cancellation) => parsed.GetValue(place) switch
            {
                Clearance => verb.ClearAsync(machine, cancellation),
                Park => machine.Profile.Park is { } park ? verb.GoToAsync(machine, park, byMachine: true, cancellation) : Task.FromResult(verb._action.NotMoved(Wording.Get("Hand.NoPark"))),
                var typed => verb.GoToAsync(machine, PlacementOptions.TryParsePosition(typed!)!.Value, parsed.GetValue(byMachine), cancellation),
            },
            stop));
        return command;
    }

    public static Command Home(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var command = verb._action.Command("home", Wording.Get("Hand.Home"));
        command.SetAction((parsed, stop) => verb._action.RunAsync(parsed, (machine, cancellation) => verb.HomeAsync(machine, cancellation), stop, homes: true));
        return command;
    }

    private async Task<int> HomeAsync(MachineSession machine, CancellationToken stop)
    {
        if (!machine.Profile.HasHoming) return _action.NotMoved(Wording.Get("Hand.NoHoming"));
        var homed = await machine.Hand.HomeAsync(JournalFolder.NewJournal("home", TimeProvider.System), stop).ConfigureAwait(false);
        if (homed.LostOrigins.Count > 0) _host.Error.WriteLine(Wording.Get("Hand.OriginsLost", string.Join(", ", homed.LostOrigins)));
        return _action.Conclude(homed.Result);
    }

    private async Task<int> GoToAsync(MachineSession machine, Point2D place, bool byMachine, CancellationToken stop)
    {
        var zero = default(CountsPoint);
        if (!byMachine)
        {
            var found = await machine.Origins.FindZeroAsync(stop).ConfigureAwait(false);
            if (found?.Frame is not { } frame) return _action.NotMoved(WhyUnplaced(found));
            zero = frame;
        }

        if (HandTarget.OfDrawing(place, zero, machine.Profile.Scale) is not { } goal) return _action.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        return _action.Conclude(await machine.Hand.GoToAsync(goal, JournalFolder.NewJournal("goto", TimeProvider.System), feed: null, stop).ConfigureAwait(false));
    }

    /// <summary>Moves a tool on a tool axis to its clearance height over the work; the position in plan does not change.</summary>
    private async Task<int> ClearAsync(MachineSession machine, CancellationToken stop)
    {
        if (machine.Profile.Height is null) return _action.NotMoved(Wording.Get("Hand.NoClearance"));
        var found = await machine.Origins.FindZeroAsync(stop).ConfigureAwait(false);
        if (found?.Frame is not { } zero || machine.Status.MachinePosition is not { } here) return _action.NotMoved(WhyUnplaced(found));
        if (HandTarget.AtClearance(here, zero, machine.Profile) is not { } goal) return _action.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        return _action.Conclude(await machine.Hand.StepAsync(goal, withHeight: true, JournalFolder.NewJournal("goto", TimeProvider.System), feed: null, stop).ConfigureAwait(false));
    }

    private static string WhyUnplaced(PlacementResult? found) => found?.Refusal is { } refused ? SettingWording.OnConsole(refused).Message : Wording.Get("Hand.WorkOriginUnknown");
}
