using Engraver.Galil.Programs;

namespace Engraver.Galil.Sessions;

/// <summary>A setting as the controller had it at connect, and the command that sets it so again.</summary>
/// <param name="Operand">What was asked, for example <c>_VAS</c>.</param>
/// <param name="Command">What goes before the number, for example <c>VAS=</c>.</param>
public sealed record FoundSetting(string Operand, string Command, double Value)
{
    public string RestoreCommand => Command + DmcFormat.Number(Value);
}
