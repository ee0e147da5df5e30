namespace Engraver.Galil.Sessions;

/// <summary>A setting as the controller had it at connect, as the command that sets it so again, to the last bit.</summary>
/// <param name="Operand">What was asked, for example <c>_VAS</c>.</param>
/// <param name="RestoreCommand">For example <c>VAS=256000</c>.</param>
public sealed record FoundSetting(string Operand, string RestoreCommand);
