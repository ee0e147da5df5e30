using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver status</c>, <c>zero</c> and <c>goto</c>: one look or one act on a machine, and then the same object.</summary>
internal sealed class HandVerbs
{
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

    public static Command Zero(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var x = new Option<bool>("--x") { Description = Wording.Get("Hand.ZeroX") };
        var y = new Option<bool>("--y") { Description = Wording.Get("Hand.ZeroY") };
        var name = new Option<string?>("--origin") { HelpName = "G54", Description = Wording.Get("Hand.ZeroOrigin") };
        name.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && WorkOriginNames.Find(token.Value) is null) result.AddError(Wording.Get("Hand.NoSuchOrigin", token.Value, string.Join(", ", WorkOriginNames.All)));
        });
        var command = verb.Command("zero", Wording.Get("Hand.Zero"));
        foreach (var option in (Option[])[x, y, name]) command.Options.Add(option);
        command.SetAction((parsed, stop) => verb.WithMachineAsync(
            parsed,
            async (machine, cancellation) =>
            {
                var (onlyX, onlyY) = (parsed.GetValue(x), parsed.GetValue(y));
                var chosen = parsed.GetValue(name) is { } given ? WorkOriginNames.Find(given) : null;
                await machine.SetOriginAsync(
                    (memory, here) => (memory with { Active = chosen ?? memory.Active }).WithOrigin(chosen ?? memory.Active, onlyX || !onlyY ? here.Position.X : null, onlyY || !onlyX ? here.Position.Y : null, null),
                    cancellation).ConfigureAwait(false);
                return ExitCode.Done;
            },
            stop));
        return command;
    }

    public static Command GoTo(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var place = new Argument<string>("X,Y") { Description = Wording.Get("Hand.Place") };
        place.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && PlacementOptions.TryPlace(token.Value) is null) result.AddError(Wording.Get("Hand.NoPlace", token.Value));
        });
        var byMachine = new Option<bool>("--machine-position") { Description = Wording.Get("Hand.ByMachine") };
        var command = verb.Command("goto", Wording.Get("Hand.GoTo"));
        command.Arguments.Add(place);
        command.Options.Add(byMachine);
        command.SetAction((parsed, stop) => verb.WithMachineAsync(
            parsed, (machine, cancellation) => verb.GoToAsync(machine, PlacementOptions.TryPlace(parsed.GetValue(place)!)!.Value, parsed.GetValue(byMachine), cancellation), stop));
        return command;
    }

    public static Command Jog(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var x = new Option<double>("--x") { HelpName = "MM", Description = Wording.Get("Hand.JogX") };
        var y = new Option<double>("--y") { HelpName = "MM", Description = Wording.Get("Hand.JogY") };
        var feed = new Option<double?>("--feed") { HelpName = "MM/MIN", Description = Wording.Get("Hand.JogFeed") };
        var command = verb.Command("jog", Wording.Get("Hand.Jog"));
        foreach (var option in (Option[])[x, y, feed]) command.Options.Add(option);
        command.Validators.Add(result =>
        {
            if (result.GetValue(x) == 0.0 && result.GetValue(y) == 0.0) result.AddError(Wording.Get("Hand.JogNowhere"));
            if (!double.IsFinite(result.GetValue(x)) || !double.IsFinite(result.GetValue(y))) result.AddError(Wording.Get("Hand.JogNowhere"));
            if (result.GetValue(feed) is { } speed && speed is not (> 0.0 and < 1e6)) result.AddError(Wording.Get("Hand.JogNoFeed", speed));
        });
        command.SetAction((parsed, stop) => verb.WithMachineAsync(
            parsed, (machine, cancellation) => verb.JogAsync(machine, new Vector2D(parsed.GetValue(x), parsed.GetValue(y)), parsed.GetValue(feed), cancellation), stop));
        return command;
    }

    private MachineCommand Command(string name, string description) => new(name, description) { _connect, _json, _profile };

    /// <summary>Connects, acts, looks once more and says what it sees.</summary>
    private async Task<int> WithMachineAsync(ParseResult parsed, Func<MachineSession, CancellationToken, Task<int>> act, CancellationToken stop)
    {
        var address = parsed.GetRequiredValue(_connect)!;
        await using var machine = new MachineSession(TimeProvider.System) { OriginsFolder = MachineMemories.FolderIn(null) };
        if (parsed.GetValue(_profile) is { } profile) machine.Profile = MachineProfileSource.Load(profile);
        await machine.ConnectAsync(address, stop).ConfigureAwait(false);
        var code = await act(machine, stop).ConfigureAwait(false);
        var status = StatusJson.From(machine.Status, machine.Hold?.Memory);
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, status, ContractJson.Default.StatusJson);
        else foreach (var line in status.Text()) await _host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        return code;
    }

    private async Task<int> GoToAsync(MachineSession machine, Point2D place, bool byMachine, CancellationToken stop)
    {
        var scale = machine.Profile.Scale;
        var zero = new CountsPoint(0, 0);
        if (!byMachine)
        {
            var found = await machine.PlaceAsync(new MotionProgram(machine.Profile, default, []), stop).ConfigureAwait(false);
            if (found?.Frame is not { } frame) return NotMoved(found?.Refusal is { } refused ? SettingWording.OnConsole(refused).Message : Wording.Get("Hand.PlaceNotKnown"));
            zero = frame;
        }

        if (!scale.Holds(Bounds2D.FromCorners(place, place), new CountsPoint(-zero.X, -zero.Y))) return NotMoved(Wording.Get("Hand.NotCountable"));
        var at = scale.ToCounts(place);
        return await MoveAsync(machine, new CountsPoint(at.X + zero.X, at.Y + zero.Y), feed: null, stop).ConfigureAwait(false);
    }

    /// <summary>A bounded step from where the machine stands.</summary>
    private async Task<int> JogAsync(MachineSession machine, Vector2D step, double? feed, CancellationToken stop)
    {
        if (machine.Status.MachinePosition is not { } here) return NotMoved(Wording.Get("Hand.PlaceNotKnown"));
        var goal = here + step;
        return machine.Profile.Scale.Holds(Bounds2D.FromCorners(goal, goal), default) ? await MoveAsync(machine, machine.Profile.Scale.ToCounts(goal), feed, stop).ConfigureAwait(false) : NotMoved(Wording.Get("Hand.NotCountable"));
    }

    private async Task<int> MoveAsync(MachineSession machine, CountsPoint goal, double? feed, CancellationToken stop)
    {
        var result = await machine.GoToAsync(goal, JournalFolder.NewJournal("goto", TimeProvider.System), feed, stop).ConfigureAwait(false);
        if (result.Outcome != JobOutcome.Complete) _host.Error.WriteLine($"engraver: {result.Sentence}");
        return result.Outcome switch { JobOutcome.Complete => ExitCode.Done, JobOutcome.Stopped => ExitCode.StoppedByOperator, JobOutcome.Refused => ExitCode.Refused, JobOutcome.Deviated => ExitCode.DrawingError, _ => ExitCode.LinkLost };
    }

    private int NotMoved(string why)
    {
        _host.Error.WriteLine(Wording.Get("Hand.NotMoved", why));
        return ExitCode.DrawingError;
    }
}
