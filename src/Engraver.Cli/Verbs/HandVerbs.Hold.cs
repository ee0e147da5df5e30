using System.CommandLine;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver jog --hold X+</c> moves until Enter, the end of the input or a signal; <c>engraver home</c> homes the machine.</summary>
internal sealed partial class HandVerbs
{
    public static Command Home(VerbHost host)
    {
        var verb = new HandVerbs(host);
        var command = verb.Command("home", Wording.Get("Hand.Home"));
        command.SetAction((parsed, stop) => verb.WithMachineAsync(parsed, (machine, cancellation) => verb.HomeAsync(machine, cancellation), stop, homes: true));
        return command;
    }

    private async Task<int> HomeAsync(MachineSession machine, CancellationToken stop)
    {
        if (!machine.Profile.HasHoming) return _host.NotMoved(Wording.Get("Hand.NoHoming"));
        var homed = await machine.HomeAsync(JournalFolder.NewJournal("home", TimeProvider.System), stop).ConfigureAwait(false);
        if (homed.Forgotten.Count > 0) _host.Error.WriteLine(Wording.Get("Hand.OriginsLost", string.Join(", ", homed.Forgotten)));
        return Concluded(homed.Result);
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
        if (way.Z != 0.0 && machine.Profile.Axes.Z is null) return _host.NotMoved(Wording.Get("Hand.NoZAxis"));
        TellUnhomed(machine);
        using var jog = machine.Presence.Begin(way.At(feed ?? machine.Profile.JogMmPerMinute));
        await using var alive = TimeProvider.System.CreateTimer(_ => machine.Presence.Sign(), null, OperatorPresence.Beat, OperatorPresence.Beat).ConfigureAwait(false); // A console has no window that could hang or lose focus.
        using var ended = CancellationTokenSource.CreateLinkedTokenSource(stop);
        var typed = Task.Run(() => ReleaseAtEnterAsync(jog, ended.Token), CancellationToken.None); // A console read blocks its thread.
        var result = await machine.JogAsync(jog, JournalFolder.NewJournal("jog", TimeProvider.System), stop).ConfigureAwait(false);
        await ended.CancelAsync().ConfigureAwait(false);
        if (typed.IsCompleted) await typed.ConfigureAwait(false);
        if (jog.Lost.IsCompleted) _host.Error.WriteLine(Wording.Get("Hand.JogDelayed"));
        return Concluded(result);
    }

    private void TellUnhomed(MachineSession machine)
    {
        if (machine.UnhomedNotice is { } notice) _host.Error.WriteLine($"engraver: {notice}");
    }

    private async Task ReleaseAtEnterAsync(HeldJog jog, CancellationToken ended)
    {
        try
        {
            await _host.In.ReadLineAsync(ended).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            // The jog has already ended.
        }

        jog.Release();
    }
}
