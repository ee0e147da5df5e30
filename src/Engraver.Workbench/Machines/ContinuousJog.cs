using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>One continuous jog: it moves while its key is pressed and the front end sends signals (<see cref="OperatorPresence"/>). Any thread.</summary>
public sealed class ContinuousJog : IDisposable
{
    private readonly TaskCompletionSource<bool> _abandoned = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Action<ContinuousJog> _end;

    internal ContinuousJog(JogControl control, Action<ContinuousJog> end) => (Control, _end) = (control, end);

    /// <summary>True after the jog was released for any reason.</summary>
    public bool IsReleased => Control.Released.IsCompleted;

    /// <summary>Completes when the jog is released without a key release: true for missing signals, false if the operator has left.</summary>
    public Task<bool> Abandoned => _abandoned.Task;

    internal JogControl Control { get; }

    /// <summary>Changes the speed in the same direction.</summary>
    public void SetSpeed(double mmPerMinute) => Control.Velocity = Control.Velocity.At(mmPerMinute);

    /// <summary>The key is released: the machine decelerates. The stop is sent on this thread without waiting for the reply.</summary>
    public void Release() => Control.Release();

    public void Dispose()
    {
        Release();
        _end(this);
    }

    internal void Abandon(bool isLate)
    {
        if (IsReleased) return;
        _abandoned.TrySetResult(isLate);
        Release();
    }
}
