using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Motion as long as a key is held (JG, BG; galil-dmc.md C). Where the travel is known the axis is sent to its end instead (PA, SP, BG): it stops
/// there and not beyond it, and a release brakes it in the same way.</summary>
/// <param name="limits">The travel that is in force, counts.</param>
/// <param name="isOver">Whether the key was released, where this is not the stop of the whole job; null where it is.</param>
internal sealed class JogMove(JobMachine machine, JogControl control, IReadOnlyList<SoftLimit> limits, Func<bool>? isOver = null) : IJobStrategy
{
    /// <summary>The longest time of a poll over a link that is fit for jogging; a serial line may take the time of its bytes in addition.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromMilliseconds(100);

    /// <summary>Bytes of a whole poll with its reply, on a serial line.</summary>
    private const int PollBytes = 260;

    /// <summary>Bytes of the longest exchange between two heartbeats.</summary>
    private const int LongestExchange = 140;

    /// <summary>A serial line must carry the longest exchange between two heartbeats in this time, or the watchdog would trip.</summary>
    private static readonly TimeSpan s_betweenHeartbeats = TimeSpan.FromMilliseconds(150);

    private readonly Dictionary<char, int> _speeds = [];
    private bool _isKept;
    private bool _isBraked;

    private TimeSpan Patience => s_patience + (machine.Line?.Time(PollBytes) ?? TimeSpan.Zero);

    /// <summary>No jog is faster than the rapid speed that is allowed now.</summary>
    private JogVelocity Velocity => control.Velocity.NoFasterThan(machine.Profile.RapidMmPerMinute);

    public Phase Whole => Phase.Idle;

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    public async ValueTask CutAsync()
    {
        CheckFitness();
        await PollAsync().ConfigureAwait(false);
        await HoldAsync().ConfigureAwait(false);
    }

    /// <summary>A jog on a machine that was kept ready, and has just been polled: its release does not end the operation in the controller, it only
    /// brakes.</summary>
    public async ValueTask KeptReadyAsync()
    {
        _isKept = true;
        if (IsReleased) return; // before anything moved
        CheckFitness();
        _ = control.Released.ContinueWith(_ => BrakeAtOnceAsync(), CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        await HoldAsync().ConfigureAwait(false);
    }

    /// <summary>The operator's side has braked. The release of a jog that is not kept ready ends the whole operation instead.</summary>
    private bool IsReleased => _isKept && control.Released.IsCompleted;

    private void CheckFitness()
    {
        if (machine.Line is { } line && line.Time(LongestExchange) > s_betweenHeartbeats) throw JobEnd.Broken(Wording.Get("JogMove.LineTooSlow", line.Baud)).ToException();
        if (Velocity is { IsZero: true }) throw JobEnd.Broken(Wording.Get("JogMove.NoAxis")).ToException();
    }

    /// <summary>Brakes every axis over the stop handle, at the same time as other commands are sent. The next poll reports a link that failed.</summary>
    private async Task BrakeAtOnceAsync()
    {
        try
        {
            await machine.Session.StopHandle.SendAsync(machine.BrakeCommand, CancellationToken.None).ConfigureAwait(false);
        }
        catch (ControllerException)
        {
            // The poll reports it, and the watchdog brakes.
        }
    }

    /// <summary>Sends the brake of a release again, after everything that this side has sent: the first one may have arrived before a BG or a JG that was
    /// being sent over another handle.</summary>
    private async ValueTask BrakeAgainAsync()
    {
        if (!IsReleased || _isBraked) return;
        _isBraked = true;
        await machine.Commands.SendAsync(machine.BrakeCommand).ConfigureAwait(false);
    }

    private async ValueTask HoldAsync()
    {
        await machine.Commands.WatchCloselyAsync().ConfigureAwait(false);
        await BeginAsync(Velocity).ConfigureAwait(false);
        while (true)
        {
            await BrakeAgainAsync().ConfigureAwait(false);
            await PollAsync().ConfigureAwait(false);
            if (isOver?.Invoke() == true)
            {
                await BrakeToRestAsync().ConfigureAwait(false);
                return;
            }

            if (machine.State.IsAtRest)
            {
                await UnlessReleasedAsync(CheckEndAsync).ConfigureAwait(false);
                return;
            }

            if (_speeds.Count > 1) await UnlessReleasedAsync(CheckNoneHaltedAsync).ConfigureAwait(false);
            if (!IsReleased) await SteerAsync(Velocity).ConfigureAwait(false);
            await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }
    }

    /// <summary>Runs a check that ends the jog, unless the key is released before the check or during it: then the axes are to be at rest.</summary>
    private async ValueTask UnlessReleasedAsync(Func<ValueTask> check)
    {
        if (!IsReleased && await JobEnd.OfAsync(check).ConfigureAwait(false) is { } end && !IsReleased) throw end.ToException();
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask BrakeToRestAsync()
    {
        await machine.Commands.SendAsync(machine.BrakeCommand).ConfigureAwait(false);
        await machine.PollUntilAsync(state => state.IsAtRest).ConfigureAwait(false);
    }

    /// <summary>A poll, with the heartbeat when it is due; the jog ends when it takes too long.</summary>
    private async ValueTask PollAsync()
    {
        var asked = machine.Time.GetTimestamp();
        await machine.PollAsync().ConfigureAwait(false);
        var took = machine.Time.GetElapsedTime(asked);
        if (took > Patience) throw JobEnd.LinkLost(Wording.Get("JogMove.LinkTooSlow", Math.Round(took.TotalMilliseconds), Math.Round(Patience.TotalMilliseconds), machine.State.Position.X, machine.State.Position.Y)).ToException();
    }

    private async ValueTask BeginAsync(JogVelocity velocity)
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
                await machine.Commands.SendAsync(DmcFormat.Text($"JG{axis.Letter}={(forward ? speed : -speed)}")).ConfigureAwait(false);
            }
            else
            {
                var here = machine.State.Position[i];
                if (forward ? here > end : here < end) throw JobEnd.Broken(Wording.Get("JogMove.Outside", machine.Profile.Axes.NameOf(axis.Letter))).ToException();
                if (here == end) continue;
                await machine.Commands.SendAllAsync([DmcFormat.Text($"SP{axis.Letter}={speed}"), DmcFormat.Text($"PA{axis.Letter}={end}")]).ConfigureAwait(false);
            }

            _speeds[axis.Letter] = speed;
            moving += axis.Letter;
        }

        if (moving.Length == 0) throw JobEnd.Broken(Wording.Get("JogMove.EndOfTravel")).ToException();
        await machine.Commands.SendAsync("BG" + moving).ConfigureAwait(false);
    }

    /// <summary>Another speed in the same direction: JG and SP act while the axis moves (galil-dmc.md C).</summary>
    private async ValueTask SteerAsync(JogVelocity velocity)
    {
        var axes = machine.Profile.Axes.All;
        for (var i = 0; i < axes.Count; i++)
        {
            if (velocity[i] == 0.0 || !_speeds.TryGetValue(axes[i].Letter, out var before)) continue;
            var (axis, speed) = (axes[i], axes[i].AxisSpeed(Math.Abs(velocity[i])));
            if (speed == before) continue;
            var forward = velocity[i] > 0.0 != axis.Scale.IsMirrored;
            var command = EndOf(axis, forward) is null ? DmcFormat.Text($"JG{axis.Letter}={(forward ? speed : -speed)}") : DmcFormat.Text($"SP{axis.Letter}={speed}");
            await machine.Commands.SendAsync(command).ConfigureAwait(false);
            _speeds[axis.Letter] = speed;
        }
    }

    /// <summary>Ends the jog when one of several axes was stopped, by a limit switch for example: the others must not continue in a direction that was not
    /// requested. An axis at the end of its travel does not end it.</summary>
    private ValueTask CheckNoneHaltedAsync() => CheckStopCodesAsync(code => code is StopCodes.Running or StopCodes.AtTarget);

    /// <summary>The axes are at rest although the key is held: at the end of the travel, at a limit switch, or because another host stopped them.</summary>
    private ValueTask CheckEndAsync() => CheckStopCodesAsync(code => code == StopCodes.AtTarget);

    private async ValueTask CheckStopCodesAsync(Func<double, bool> isRight)
    {
        var codes = await machine.Commands.AskAllAsync(string.Join(',', _speeds.Keys.Select(letter => $"_SC{letter}"))).ConfigureAwait(false);
        var at = machine.State.Position;
        foreach (var code in codes)
        {
            if (!isRight(code)) throw JobEnd.Broken(Wording.Get("JogMove.Ended", at.X, at.Y, StopCodes.Text((int)code))).ToException();
        }
    }

    private int? EndOf(MachineAxis axis, bool forward)
    {
        foreach (var limit in limits)
        {
            if (limit.Axis == axis.Letter) return forward ? limit.Max : limit.Min;
        }

        return null;
    }
}
