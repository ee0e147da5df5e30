using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Geometry;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Verbs.Hand;

/// <summary><c>engraver jog</c> moves by a step; with <c>--hold X+</c> until Enter, the end of the input or a signal.</summary>
internal sealed class JogVerb
{
    private readonly VerbHost _host;
    private readonly MachineAction _action;

    private JogVerb(VerbHost host) => (_host, _action) = (host, new MachineAction(host));

    public static Command Build(VerbHost host)
    {
        var verb = new JogVerb(host);
        var x = new Option<double>("--x") { HelpName = "MM", Description = Wording.Get("Hand.JogX"), CustomParser = OptionValue.AnyNumber };
        var y = new Option<double>("--y") { HelpName = "MM", Description = Wording.Get("Hand.JogY"), CustomParser = OptionValue.AnyNumber };
        var z = new Option<double>("--z") { HelpName = "MM", Description = Wording.Get("Hand.JogZ"), CustomParser = OptionValue.AnyNumber };
        var feed = new Option<double?>("--feed") { HelpName = "MM/MIN", Description = Wording.Get("Hand.JogFeed"), CustomParser = result => OptionValue.Speed(result) };
        var command = verb._action.Command("jog", Wording.Get("Hand.Jog"));
        var hold = new Option<string?>("--hold") { HelpName = "X+|X-|Y+|Y-|Z+|Z-", Description = Wording.Get("Hand.JogHold") };
        foreach (var option in (Option[])[x, y, z, feed, hold]) command.Options.Add(option);
        command.SetAction((parsed, stop) =>
        {
            var (step, height) = (new Vector2D(parsed.GetValue(x), parsed.GetValue(y)), parsed.GetValue(z));
            var isStep = step != default || height != 0.0;
            if (parsed.GetValue(hold) is not { } way)
            {
                if (!isStep) throw new UsageException(Wording.Get("Hand.JogWithoutDistance"));
                return verb._action.RunAsync(parsed, (machine, cancellation) => verb.JogAsync(machine, step, height, parsed.GetValue(feed), cancellation), stop);
            }

            if (isStep) throw new UsageException(Wording.Get("Hand.JogHoldOrStep"));
            var direction = Direction(way) ?? throw new UsageException(Wording.Get("Hand.InvalidJogDirection", way));
            return verb._action.RunAsync(parsed, (machine, cancellation) => verb.HoldAsync(machine, direction, parsed.GetValue(feed), cancellation), stop);
        });
        return command;
    }

    /// <summary>A step from the machine's position.</summary>
    /// <param name="height">Up or down, mm.</param>
    private async Task<int> JogAsync(MachineSession machine, Vector2D step, double height, double? feed, CancellationToken stop)
    {
        if (machine.Status.MachinePosition is not { } here) return _action.NotMoved(Wording.Get("Hand.MachinePositionUnknown"));
        if (height != 0.0 && machine.Profile.Axes.Z is null) return _action.NotMoved(Wording.Get("Hand.NoZAxis"));
        if (HandTarget.FromStep(here, machine.Status.MachineHeight ?? 0.0, step, height, machine.Profile.Scale) is not { } goal) return _action.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        TellUnhomed(machine);
        return _action.Conclude(await machine.Hand.StepAsync(goal, height != 0.0, JournalFolder.NewJournal("jog", TimeProvider.System), feed, stop).ConfigureAwait(false));
    }

    private static JogVelocity? Direction(string way) => way.ToUpperInvariant() switch
    {
        "X+" => new JogVelocity(1, 0),
        "X-" => new JogVelocity(-1, 0),
        "Y+" => new JogVelocity(0, 1),
        "Y-" => new JogVelocity(0, -1),
        "Z+" => new JogVelocity(0, 0, 1),
        "Z-" => new JogVelocity(0, 0, -1),
        _ => null,
    };

    private async Task<int> HoldAsync(MachineSession machine, JogVelocity way, double? feed, CancellationToken stop)
    {
        if (way.Z != 0.0 && machine.Profile.Axes.Z is null) return _action.NotMoved(Wording.Get("Hand.NoZAxis"));
        TellUnhomed(machine);
        using var jog = machine.Hand.Presence.BeginJog(way.At(feed ?? machine.Profile.JogMmPerMinute));
        await using var alive = TimeProvider.System.CreateTimer(_ => machine.Hand.Presence.Sign(), null, OperatorPresence.SignInterval, OperatorPresence.SignInterval).ConfigureAwait(false); // a console has no window that could hang or be left
        using var ended = CancellationTokenSource.CreateLinkedTokenSource(stop);
        var typed = Task.Run(() => ReleaseAtEnterAsync(jog, ended.Token), CancellationToken.None); // a console blocks the thread that reads it
        var result = await machine.Hand.JogAsync(jog, JournalFolder.NewJournal("jog", TimeProvider.System), stop).ConfigureAwait(false);
        await ended.CancelAsync().ConfigureAwait(false);
        if (typed.IsCompleted) await typed.ConfigureAwait(false);
        if (jog.Abandoned.IsCompleted) _host.Error.WriteLine(Wording.Get("Hand.JogDelayed"));
        return _action.Conclude(result);
    }

    private void TellUnhomed(MachineSession machine)
    {
        if (machine.Hand.UnhomedNotice is { } notice) _host.Error.WriteLine($"engraver: {notice}");
    }

    private async Task ReleaseAtEnterAsync(ContinuousJog jog, CancellationToken ended)
    {
        try
        {
            await _host.In.ReadLineAsync(ended).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            // The jog has ended without Enter.
        }

        jog.Release();
    }
}
