using Avalonia.Input;

namespace Engraver.App.Safety;

/// <summary>The keys that stop the machine: Pause and Ctrl+Space always stop; Esc holds the job while anything moves, and stops what cannot be held. Asked
/// on the thread that reads the input, so a busy window does not delay them.</summary>
/// <param name="isMoving">From any thread.</param>
/// <param name="stop">From any thread; waits for nothing.</param>
/// <param name="hold">The same.</param>
public sealed class StopKeys(Func<bool> isMoving, Action stop, Action hold)
{
    /// <summary>Esc has held or stopped what moves; on the thread that reads the input. The window gives the keyboard back to the command line.</summary>
    public event Action? Escaped;

    /// <summary>The on-screen STOP was pressed; the press goes on to the window, so that the key is seen going down.</summary>
    public bool PressStop()
    {
        stop();
        return false;
    }

    /// <summary>A key went down.</summary>
    /// <returns>True when it was one of the stop keys and means nothing else.</returns>
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
