namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

/// <summary>Letters with one baseline, one after the other.</summary>
/// <param name="X">Origin of the first letter.</param>
/// <param name="Y">Of the baseline.</param>
/// <param name="LastX">Origin of the last letter.</param>
internal sealed record LaidRow(string Letters, double X, double Y, double LastX);
