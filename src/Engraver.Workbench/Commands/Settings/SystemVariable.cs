namespace Engraver.Workbench.Commands.Settings;

/// <summary>A value that is typed by its name, as in AutoCAD.</summary>
/// <param name="First">Its value at the first start.</param>
/// <param name="IsInteger">Only whole numbers.</param>
internal sealed record SystemVariable(
    string Name, double First, double Min, double Max, bool IsInteger, Func<CommandContext, double> Read, Action<CommandContext, double> Write);
