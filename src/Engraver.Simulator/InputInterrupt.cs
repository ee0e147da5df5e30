namespace Engraver.Simulator;

/// <summary>II (galil-dmc.md D): when a watched input has its interrupt level, #ININT runs in thread 0; RI arms it again.</summary>
internal sealed class InputInterrupt
{
    private byte _inputs;
    private byte _levels;

    /// <summary>Bit 3 of TB: a watched input starts #ININT.</summary>
    public bool IsArmed { get; private set; }

    /// <summary>Bit 2 of TB: #ININT runs.</summary>
    public bool IsRunning { get; private set; }

    /// <param name="inputs">Mask of the inputs watched; 0 disables.</param>
    /// <param name="levels">The level that interrupts, one bit for each input: 1 high, 0 (the default) low.</param>
    public void Arm(byte inputs, byte levels)
    {
        _inputs = inputs;
        _levels = levels;
        IsRunning = false;
        IsArmed = inputs != 0;
    }

    /// <summary>RI: #ININT has ended and may be started again.</summary>
    public void Rearm()
    {
        if (IsRunning) Arm(_inputs, _levels);
    }

    public bool IsDue(byte inputs) => IsArmed && (~(inputs ^ _levels) & _inputs) != 0;

    public void Taken() => (IsArmed, IsRunning) = (false, true);
}
