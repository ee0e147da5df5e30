namespace Engraver.Workbench.SerialTexts;

/// <summary>A counter as a drawing uses it.</summary>
/// <param name="Start">Its first number where the book does not have the counter.</param>
/// <param name="Increment">From one plate to the next.</param>
public sealed record CounterDesign(string Name, long Start, long Increment)
{
    public const long DefaultStart = 1;

    public const long DefaultIncrement = 1;
}
