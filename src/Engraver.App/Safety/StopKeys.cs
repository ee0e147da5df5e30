using Avalonia.Input;

namespace Engraver.App.Safety;

/// <summary>The keys that stop the machine: Pause and Ctrl+Space always stop; Esc holds the job while anything moves, and stops what cannot be held. Called
/// on the thread that reads the input, so that a busy window does not delay them.</summary>
/// <param name="isMoving">From any thread.</param>
/// <param name="stop">From any thread; does not wait.</param>
/// <param name="hold">The same.</param>
public sealed class StopKeys(Func<bool> isMoving, Action stop, Action hold)
{
    /// <summary>Esc has held or stopped a motion; raised on the thread that reads the input. The window then returns the focus to the command
    /// line.</summary>
    public event Action? Escaped;

    /// <summary>The on-screen STOP was pressed; the press is passed on to the window, which shows the key as pressed.</summary>
    public bool PressStop()
    {
        stop();
        return false;
    }

    /// <summary>A key was pressed.</summary>
    /// <returns>True if it was a stop key and has no other meaning.</returns>
    public bool Press(Key key, KeyModifiers modifiers)
    {
        if (key == Key.Pause || (key == Key.Space && modifiers.HasFlag(KeyModifiers.Control)))
        {
            stop();
            return true;
        }

        if (key == Key.Escape && isMoving())
        {
            hold();
            Escaped?.Invoke();
            return true;
        }

        return false;
    }
}
