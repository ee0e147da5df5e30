namespace Engraver.Workbench.Commands;

/// <summary>A displayed step.</summary>
/// <param name="Number">From 1.</param>
public sealed record CommissioningStepView(int Number, string Name, CommissioningState State);
