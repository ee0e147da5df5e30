namespace Engraver.Simulator.Language;

/// <summary>Ends the execution of one command with a TC code. Thrown anywhere in the interpreter, caught in exactly two places: where a host command and where a program line ends.</summary>
internal sealed class CommandRefusedException(int code) : Exception(Tc.TextOf(code))
{
    public int Code { get; } = code;
}
