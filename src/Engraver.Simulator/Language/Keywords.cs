using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Names that look like variables but belong to the controller: TIME (galil-dmc.md C) and the input of the serial port (CI, C.3).</summary>
internal static class Keywords
{
    public static bool IsReserved(ReadOnlySpan<char> name) => name is "TIME" or "P1CH" or "P1ST" or "P1NM" or "P1CD";

    public static bool TryRead(Machine machine, ReadOnlySpan<char> name, out FixedPoint value)
    {
        value = default;
        if (name.Length != 4 || !IsReserved(name)) return false;
        value = name switch
        {
            "TIME" => FixedPoint.FromInteger((int)machine.Time),
            "P1CH" => machine.SerialInterrupt.Character,
            "P1ST" => machine.SerialInterrupt.ReadText(),
            "P1NM" => machine.SerialInterrupt.ReadNumber(),
            _ => FixedPoint.FromInteger(machine.SerialInterrupt.Code),
        };
        return true;
    }
}
