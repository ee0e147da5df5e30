using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;

namespace Engraver.App.HandMoves;

/// <summary>One jog by the pad: it lives as long as the key is held and the window answers.</summary>
/// <remarks>A window that is busy does not hear that the key is released, so it has to say again and again that it is alive (<see cref="IsHeld"/>); otherwise the jog is released from another thread.</remarks>
public sealed class HeldJog : IDisposable
{
    /// <summary>The window is asked this often.</summary>
    public static readonly TimeSpan Beat = TimeSpan.FromMilliseconds(50);

    private static readonly TimeSpan s_patience = TimeSpan.FromMilliseconds(300);
    private readonly JogControl _control;
    private readonly TimeProvider _time;
    private readonly ITimer _watch;
    private long _heard;
    private int _released;

    private HeldJog(JogControl control, TimeProvider time)
    {
        (_control, _time) = (control, time);
        _heard = time.GetTimestamp();
        _watch = time.CreateTimer(_ => Look(), null, Beat, Beat);
    }

    /// <summary>The window did not answer in time.</summary>
    public bool WasLate { get; private set; }

    public bool IsReleased => Volatile.Read(ref _released) != 0;

    /// <summary>Completes with how it ended.</summary>
    public Task<JobResult> Ended { get; private set; } = Task.FromResult(JobResult.NotStarted(0, ""));

    /// <param name="before">The jog before this one, which leaves the controller as it was found first.</param>
    /// <param name="journal">Where what is found in the controller is written down.</param>
    public static HeldJog Begin(MachineSession machine, JogVelocity velocity, Task before, string journal, TimeProvider time)
    {
        var jog = new HeldJog(new JogControl(velocity), time);
        jog.Ended = Task.Run(() => jog.RunAsync(machine, before, journal));
        return jog;
    }

    /// <summary>The key is still held, at this speed. On the window's thread.</summary>
    public void IsHeld(double mmPerMinute)
    {
        Volatile.Write(ref _heard, _time.GetTimestamp());
        _control.Velocity = _control.Velocity.At(mmPerMinute);
    }

    /// <summary>The key is released. Any thread; waits for nothing.</summary>
    public void Release()
    {
        if (Interlocked.Exchange(ref _released, 1) == 0) _control.Release();
    }

    public void Dispose()
    {
        Release();
        _watch.Dispose();
    }

    private async Task<JobResult> RunAsync(MachineSession machine, Task before, string journal)
    {
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        return IsReleased ? JobResult.NotStarted(0, "") : await machine.JogAndStayReadyAsync(_control, journal).ConfigureAwait(false);
    }

    private void Look()
    {
        if (IsReleased || _time.GetElapsedTime(Volatile.Read(ref _heard)) < s_patience) return;
        WasLate = true;
        Release();
    }
}
