using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language.Commands;

/// <summary>The condition that MC waits for: the end of the profiles and the motors in position, but no longer than TW (galil-dmc.md C, MC).</summary>
internal sealed class MotionComplete(Machine machine, Axis[] axes)
{
    private const double UsualTimeOut = 32766;
    private const double SmoothingSamples = 3;
    private long? _profileEnd;
    private bool _over;

    /// <summary>Tested in every sample; the time-out sets its stop code once.</summary>
    public bool IsOver()
    {
        if (_over || Array.Exists(axes, machine.Motion.IsBusy)) return _over;
        _profileEnd ??= machine.Sample;
        var waited = machine.Sample - _profileEnd.Value;
        _over = Array.TrueForAll(axes, a => IsInPosition(a, waited));
        if (_over) return true;
        foreach (var axis in axes)
        {
            var limit = axis.Setting("TW", UsualTimeOut);
            if (limit < 0 || waited < limit || IsInPosition(axis, waited)) continue;
            axis.StopCode = StopCode.MotionTimeOut;
            _over = true;
        }

        if (_over) machine.Threads.Interrupt("MCTIME");
        return _over;
    }

    /// <summary>A stepper is in position when its smoothed pulses have been sent, 3 KS samples after the profile (C, KS).</summary>
    private static bool IsInPosition(Axis axis, long waited) =>
        axis.IsStepper ? waited >= SmoothingSamples * axis.Setting("KS", 2) : Math.Abs(axis.Error) < 1;
}
