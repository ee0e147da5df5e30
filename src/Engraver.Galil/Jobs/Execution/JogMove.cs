using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Motion as long as a key is held (JG, BG; galil-dmc.md C). Where the travel is known the axis is sent to its end instead (PA, SP, BG): it stops
/// there and not behind it, and a release brakes it just the same.</summary>
/// <param name="limits">The travel that is in force, counts.</param>
/// <param name="isOver">Whether the key was released, where no stop of the whole job says so; null where one does.</param>
internal sealed class JogMove(JobMachine machine, JogControl control, IReadOnlyList<SoftLimit> limits, Func<bool>? isOver = null) : IJobStrategy
{
    /// <summary>The longest time for a look at the machine over a link that is fit for jogging; a serial line may take the time of its bytes besides.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromMilliseconds(100);

    /// <summary>Bytes of a whole look with its answer, on a serial line.</summary>
    private const int LookBytes = 260;

    /// <summary>Bytes of the longest exchange between two signs.</summary>
    private const int LongestExchange = 140;

    /// <summary>A serial line must carry the longest exchange between two signs in this time, or the dead-man would trip.</summary>
    private static readonly TimeSpan s_betweenSigns = TimeSpan.FromMilliseconds(150);

    private readonly Dictionary<char, int> _speeds = [];
    private bool _isKept;
    private bool _isBraked;

    private TimeSpan Patience => s_patience + (machine.Line?.Time(LookBytes) ?? TimeSpan.Zero);

    /// <summary>No jog is faster than the rapid speed that is allowed now.</summary>
    private JogVelocity Velocity => control.Velocity.NoFasterThan(machine.Profile.RapidMmPerMinute);

    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public async ValueTask<JobStep> CutAsync()
    {
        if (Unfit() is { Ends: true } unfit) return unfit;
        if (await LookAsync().ConfigureAwait(false) is { Ends: true } slow) return slow;
        return await HoldAsync().ConfigureAwait(false);
    }

    /// <summary>A jog on a machine that was kept ready, and has been polled just now: its release does not end the operation in the controller, it only
    /// brakes.</summary>
    public async ValueTask<JobStep> KeptReadyAsync()
    {
        _isKept = true;
        if (IsReleased) return JobStep.Done; // before anything moved
        if (Unfit() is { Ends: true } unfit) return unfit;
        _ = control.Released.ContinueWith(_ => machine.BrakeAsync(), CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        return await HoldAsync().ConfigureAwait(false);
    }

    /// <summary>The operator's side has braked; of a jog that is not one of several the release ends the whole operation instead.</summary>
    private bool IsReleased => _isKept && control.Released.IsCompleted;

    private JobStep Unfit()
    {
        if (machine.Line is { } line && line.Time(LongestExchange) > s_betweenSigns) return JobStep.Broken(Wording.Get("JogMove.LineTooSlow", line.Baud));
        return Velocity is { IsZero: true } ? JobStep.Broken(Wording.Get("JogMove.NoAxis")) : JobStep.Done;
    }

    /// <summary>The brake of a release once more, behind whatever this side has sent: the first one may have been before a BG or a JG that was on its way
    /// over another handle.</summary>
    private async ValueTask<JobStep> BrakeAsync()
    {
        if (!IsReleased || _isBraked) return JobStep.Done;
        _isBraked = true;
        return await machine.SendAsync(machine.BrakeCommand).ConfigureAwait(false);
    }

    private async ValueTask<JobStep> HoldAsync()
    {
        if (await machine.WatchCloselyAsync().ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        if (await BeginAsync(Velocity).ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        while (true)
        {
            if (await BrakeAsync().ConfigureAwait(false) is { Ends: true } unbraked) return unbraked;
            if (await LookAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            if (isOver?.Invoke() == true) return await BrakeToRestAsync().ConfigureAwait(false);
            if (machine.State.Stands) return IsReleased || await EndedAsync().ConfigureAwait(false) is not { Ends: true } ended || IsReleased ? JobStep.Done : ended;
            if (!IsReleased && _speeds.Count > 1 && await IsAnyHaltedAsync().ConfigureAwait(false) is { Ends: true } halted && !IsReleased) return halted; // a release may come while it is asked
            if (!IsReleased && await SteerAsync(Velocity).ConfigureAwait(false) is { Ends: true } lost) return lost;
            await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask<JobStep> BrakeToRestAsync() =>
        await machine.SendAsync(machine.BrakeCommand).ConfigureAwait(false) is { Ends: true } refused ? refused : await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false);

    /// <summary>A look, with a sign of this computer when it is due; the jog ends when it takes too long.</summary>
    private async ValueTask<JobStep> LookAsync()
    {
        var asked = machine.Time.GetTimestamp();
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var took = machine.Time.GetElapsedTime(asked);
        return took <= Patience
            ? JobStep.Done
            : JobStep.LinkLost(Wording.Get("JogMove.LinkTooSlow", Math.Round(took.TotalMilliseconds), Math.Round(Patience.TotalMilliseconds), machine.State.Position.X, machine.State.Position.Y));
    }

    private async ValueTask<JobStep> BeginAsync(JogVelocity velocity)
    {
        var axes = machine.Profile.Axes.All;
        var moving = "";
        for (var i = 0; i < axes.Count; i++)
        {
            if (velocity[i] == 0.0) continue;
            var (axis, speed) = (axes[i], axes[i].AxisSpeed(Math.Abs(velocity[i])));
            var forward = velocity[i] > 0.0 != axis.Scale.IsMirrored;
            if (EndOf(axis, forward) is not { } end)
            {
                if (await machine.SendAsync(Text($"JG{axis.Letter}={(forward ? speed : -speed)}")).ConfigureAwait(false) is { Ends: true } refused) return refused;
            }
            else
            {
                var here = machine.State.Position[i];
                if (forward ? here > end : here < end) return JobStep.Broken(Wording.Get("JogMove.Outside", machine.Profile.Axes.NameOf(axis.Letter)));
                if (here == end) continue;
                if (await machine.SendAllAsync([Text($"SP{axis.Letter}={speed}"), Text($"PA{axis.Letter}={end}")]).ConfigureAwait(false) is { Ends: true } refused) return refused;
            }

            _speeds[axis.Letter] = speed;
            moving += axis.Letter;
        }

        return moving.Length == 0 ? JobStep.Broken(Wording.Get("JogMove.EndOfTravel")) : await machine.SendAsync("BG" + moving).ConfigureAwait(false);
    }

    /// <summary>Another speed in the same direction: JG and SP act while the axis moves (galil-dmc.md C).</summary>
    private async ValueTask<JobStep> SteerAsync(JogVelocity velocity)
    {
        var axes = machine.Profile.Axes.All;
        for (var i = 0; i < axes.Count; i++)
        {
            if (velocity[i] == 0.0 || !_speeds.TryGetValue(axes[i].Letter, out var before)) continue;
            var (axis, speed) = (axes[i], axes[i].AxisSpeed(Math.Abs(velocity[i])));
            if (speed == before) continue;
            var forward = velocity[i] > 0.0 != axis.Scale.IsMirrored;
            var command = EndOf(axis, forward) is null ? Text($"JG{axis.Letter}={(forward ? speed : -speed)}") : Text($"SP{axis.Letter}={speed}");
            if (await machine.SendAsync(command).ConfigureAwait(false) is { Ends: true } refused) return refused;
            _speeds[axis.Letter] = speed;
        }

        return JobStep.Done;
    }

    /// <summary>Ends the jog when one of several axes was stopped, by a limit switch for example: the others must not go on in a direction that nobody
    /// asked for. An axis at the end of its travel does not end it.</summary>
    private async ValueTask<JobStep> IsAnyHaltedAsync()
    {
        var (codes, end) = await machine.AskAllAsync(StopCodeOperands).ConfigureAwait(false);
        if (end.Ends) return end;
        var at = machine.State.Position;
        return codes.FirstOrDefault(code => code is not (StopCodes.Running or StopCodes.AtTarget), StopCodes.AtTarget) is var halted && halted != StopCodes.AtTarget
            ? JobStep.Broken(Wording.Get("JogMove.Ended", at.X, at.Y, StopCodes.Text((int)halted)))
            : JobStep.Done;
    }

    private string StopCodeOperands => string.Join(',', _speeds.Keys.Select(letter => $"_SC{letter}"));

    /// <summary>The axes stand though the key is held: at the end of the travel, at a limit switch, or because somebody stopped them.</summary>
    private async ValueTask<JobStep> EndedAsync()
    {
        var (codes, end) = await machine.AskAllAsync(StopCodeOperands).ConfigureAwait(false);
        if (end.Ends) return end;
        var at = machine.State.Position;
        return codes.FirstOrDefault(code => code != StopCodes.AtTarget, StopCodes.AtTarget) is var code && code == StopCodes.AtTarget
            ? JobStep.Done
            : JobStep.Broken(Wording.Get("JogMove.Ended", at.X, at.Y, StopCodes.Text((int)code)));
    }

    private int? EndOf(MachineAxis axis, bool forward)
    {
        foreach (var limit in limits)
        {
            if (limit.Axis == axis.Letter) return forward ? limit.Most : limit.Least;
        }

        return null;
    }
}
