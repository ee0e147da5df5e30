namespace Engraver.Workbench.CommandLanguage;

/// <summary>A prompt for a value of a type.</summary>
public abstract record ValuePrompt<T>(string Instruction) : Prompt(Instruction)
{
    /// <summary>Returns why a value is rejected, null if it is accepted. A rejected value is asked for again without losing earlier answers. Without this
    /// function every value is accepted.</summary>
    public Func<T, string?>? Validate { get; init; }

    /// <summary>Reads what was typed (never empty).</summary>
    /// <param name="lastPoint">What <c>@</c> is relative to, drawing units.</param>
    /// <returns>The value, or a sentence that states which input is expected.</returns>
    public abstract ParsedInput<T> Parse(string typed, Core.Geometry.Point2D lastPoint);
}
