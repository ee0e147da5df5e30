using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver status</c>, <c>zero</c> and <c>goto</c>: one query or one action on a machine, then the same JSON object.</summary>
internal sealed partial class HandVerbs
{
    /// <summary>Named positions.</summary>
    private const string Park = "park";
    private const string Clearance = "clearance";

    private readonly VerbHost _host;
    private readonly Option<ControllerAddress?> _connect = ConnectOption.New(required: true, Wording.Get("Hand.Connect"));
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string?> _profile = new("--machine") { HelpName = "PROFILE.json", Description = Wording.Get("Hand.Machine") };

    private HandVerbs(VerbHost host) => _host = host;

    public static Command Status(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var command = verb.Command("status", Wording.Get("Hand.Status"));
        command.SetAction((parsed, stop) => verb.WithMachineAsync(parsed, (_, _) => Task.FromResult(ExitCode.Done), stop));
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
        var command = verb.Command("motors", Wording.Get("Hand.Motors"));
        command.Arguments.Add(state);
        command.SetAction((parsed, stop) => verb.WithMachineAsync(parsed, (machine, cancellation) => verb.SwitchAsync(machine, parsed.GetValue(state)!.Equals("on", StringComparison.OrdinalIgnoreCase), cancellation), stop));
        return command;
    }

    private async Task<int> SwitchAsync(MachineSession machine, bool on, CancellationToken stop)
    {
        if (await machine.SetMotorsAsync(on, stop).ConfigureAwait(false) is not { } refused) return ExitCode.Done;
        _host.Error.WriteLine($"engraver: {refused.Sentence}");
        return ExitCode.Refused;
    }

    public static Command GoTo(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var place = new Argument<string?>("X,Y|park|clearance") { Description = Wording.Get("Hand.Target") };
        place.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && token.Value is not (Park or Clearance) && PlacementOptions.TryPlace(token.Value) is null) result.AddError(Wording.Get("Hand.InvalidTarget", token.Value));
        });
        var byMachine = new Option<bool>("--machine-position") { Description = Wording.Get("Hand.ByMachinePosition") };
        var command = verb.Command("goto", Wording.Get("Hand.GoTo"));
        command.Arguments.Add(place);
        command.Options.Add(byMachine);
        command.SetAction((parsed, stop) => verb.WithMachineAsync(
            parsed,
            (machine, cancellation) => parsed.GetValue(place) switch
            {
                Clearance => verb.ClearAsync(machine, cancellation),
                Park => machine.Profile.Park is { } park ? verb.GoToAsync(machine, park, byMachine: true, cancellation) : Task.FromResult(verb._host.NotMoved(Wording.Get("Hand.NoPark"))),
                var typed => verb.GoToAsync(machine, PlacementOptions.TryPlace(typed!)!.Value, parsed.GetValue(byMachine), cancellation),
            },
            stop));
        return command;
    }

    public static Command Jog(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var x = new Option<double>("--x") { HelpName = "MM", Description = Wording.Get("Hand.JogX"), CustomParser = OptionValue.AnyNumber };
        var y = new Option<double>("--y") { HelpName = "MM", Description = Wording.Get("Hand.JogY"), CustomParser = OptionValue.AnyNumber };
        var z = new Option<double>("--z") { HelpName = "MM", Description = Wording.Get("Hand.JogZ"), CustomParser = OptionValue.AnyNumber };
        var feed = new Option<double?>("--feed") { HelpName = "MM/MIN", Description = Wording.Get("Hand.JogFeed"), CustomParser = result => OptionValue.Speed(result) };
        var command = verb.Command("jog", Wording.Get("Hand.Jog"));
        var hold = new Option<string?>("--hold") { HelpName = "X+|X-|Y+|Y-|Z+|Z-", Description = Wording.Get("Hand.JogHold") };
        foreach (var option in (Option[])[x, y, z, feed, hold]) command.Options.Add(option);
        command.SetAction((parsed, stop) =>
        {
            var (step, height) = (new Vector2D(parsed.GetValue(x), parsed.GetValue(y)), parsed.GetValue(z));
            var isStep = step != default || height != 0.0;
            if (parsed.GetValue(hold) is not { } way)
            {
                if (!isStep) throw new UsageException(Wording.Get("Hand.JogWithoutDistance"));
                return verb.WithMachineAsync(parsed, (machine, cancellation) => verb.JogAsync(machine, step, height, parsed.GetValue(feed), cancellation), stop);
            }

            if (isStep) throw new UsageException(Wording.Get("Hand.JogHoldOrStep"));
            var direction = Direction(way) ?? throw new UsageException(Wording.Get("Hand.InvalidJogDirection", way));
            return verb.WithMachineAsync(parsed, (machine, cancellation) => verb.HoldAsync(machine, direction, parsed.GetValue(feed), cancellation), stop);
        });
        return command;
    }

    private MachineCommand Command(string name, string description) => new(name, description) { _connect, _json, _profile };

    /// <summary>Connects, runs the action, polls the machine again and reports its state.</summary>
    /// <param name="homes">The action homes the machine: a simulated machine then starts away from its home switches.</param>
    private async Task<int> WithMachineAsync(ParseResult parsed, Func<MachineSession, CancellationToken, Task<int>> act, CancellationToken stop, bool homes = false)
    {
        var address = parsed.GetRequiredValue(_connect)!;
        await using var machine = new MachineSession(TimeProvider.System) { OriginsFolder = MachineMemories.FolderIn(null), SimulatedIsHomed = !homes };
        if (parsed.GetValue(_profile) is { } profile) machine.Profile = ProfileOption.Load(parsed, profile);
        await machine.ConnectAsync(address, stop).ConfigureAwait(false);
        var code = await act(machine, stop).ConfigureAwait(false);
        var status = StatusJson.From(machine.Status, machine.Hold?.Memory, machine.Profile);
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, status, ContractJson.Default.StatusJson);
        else foreach (var line in status.Text()) await _host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        return code;
    }

    private async Task<int> GoToAsync(MachineSession machine, Point2D place, bool byMachine, CancellationToken stop)
    {
        var zero = default(CountsPoint);
        if (!byMachine)
        {
            var found = await machine.FindZeroAsync(stop).ConfigureAwait(false);
            if (found?.Frame is not { } frame) return _host.NotMoved(WhyUnplaced(found));
            zero = frame;
        }

        if (HandPlace.OfDrawing(place, zero, machine.Profile.Scale) is not { } goal) return _host.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        return Concluded(await machine.GoToAsync(goal, JournalFolder.NewJournal("goto", TimeProvider.System), feed: null, stop).ConfigureAwait(false));
    }

    /// <summary>Raises the tool axis to the clearance height above the work; X and Y do not move.</summary>
    private async Task<int> ClearAsync(MachineSession machine, CancellationToken stop)
    {
        if (machine.Profile.Height is null) return _host.NotMoved(Wording.Get("Hand.NoClearance"));
        var found = await machine.FindZeroAsync(stop).ConfigureAwait(false);
        if (found?.Frame is not { } zero || machine.Status.MachinePosition is not { } here) return _host.NotMoved(WhyUnplaced(found));
        if (HandPlace.AtClearance(here, zero, machine.Profile) is not { } goal) return _host.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        return Concluded(await machine.StepAsync(goal, withHeight: true, JournalFolder.NewJournal("goto", TimeProvider.System), feed: null, stop).ConfigureAwait(false));
    }

    private static string WhyUnplaced(PlacementResult? found) => found?.Refusal is { } refused ? SettingWording.OnConsole(refused).Message : Wording.Get("Hand.WorkOriginUnknown");

    /// <summary>A step of limited length from the current position.</summary>
    /// <param name="height">Up or down, mm.</param>
    private async Task<int> JogAsync(MachineSession machine, Vector2D step, double height, double? feed, CancellationToken stop)
    {
        if (machine.Status.MachinePosition is not { } here) return _host.NotMoved(Wording.Get("Hand.MachinePositionUnknown"));
        if (height != 0.0 && machine.Profile.Axes.Z is null) return _host.NotMoved(Wording.Get("Hand.NoZAxis"));
        if (HandPlace.Beside(here, machine.Status.MachineHeight ?? 0.0, step, height, machine.Profile.Scale) is not { } goal) return _host.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        TellUnhomed(machine);
        return Concluded(await machine.StepAsync(goal, height != 0.0, JournalFolder.NewJournal("jog", TimeProvider.System), feed, stop).ConfigureAwait(false));
    }

    /// <summary>Reports why a move did not finish.</summary>
    private int Concluded(JobResult result)
    {
        if (result is { Outcome: JobOutcome.Refused, Diagnostics: [{ } refusal, ..], FinalPosition: null }) return _host.NotMoved(SettingWording.OnConsole(refusal).Message);
        if (result.Outcome != JobOutcome.Complete) _host.Error.WriteLine($"engraver: {result.Sentence}");
        foreach (var left in result.NotRestored) _host.Error.WriteLine(Wording.Get("Run.NotRestored", left));
        return ExitCode.Of(result.Outcome);
    }
}
