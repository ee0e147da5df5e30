namespace Engraver.Simulator.Values;

/// <summary>Ends the execution of one command with a TC code. Thrown anywhere in the interpreter and caught in exactly two places: at the end of a host command
/// and at the end of a program line.</summary>
internal sealed class CommandRefusedException(int code) : Exception(Tc.TextOf(code))
{
    public int Code { get; } = code;
}
