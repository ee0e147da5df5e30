namespace Engraver.Workbench.Commands;

/// <summary>A value that is typed by its name, as in AutoCAD.</summary>
/// <param name="Summary">One sentence for the help.</param>
/// <param name="First">Its value at the first start.</param>
/// <param name="Whole">Only whole numbers.</param>
internal sealed record SystemVariable(
    string Name, string Summary, double First, double Least, double Most, bool Whole, Func<CommandContext, double> Read, Action<CommandContext, double> Write);
