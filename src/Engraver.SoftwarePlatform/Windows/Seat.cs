using Avalonia.Input;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Shared by the windows of one application: keyboard, input filter, screen, clock and stacking order.</summary>
internal sealed class Seat(InputGate gate, IScreenImpl screens, TimeProvider time)
{
    private readonly long _start = time.GetTimestamp();
    private long _stacking;

    public IKeyboardDevice Keyboard { get; } = new KeyboardDevice();

    public InputGate Gate => gate;

    public IScreenImpl Screens => screens;

    /// <summary>Milliseconds since the seat was made: the time stamp of input events.</summary>
    public ulong Now => (ulong)time.GetElapsedTime(_start).TotalMilliseconds;

    public long NextStacking() => ++_stacking;
}
