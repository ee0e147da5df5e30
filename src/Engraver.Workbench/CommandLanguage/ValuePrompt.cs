namespace Engraver.Workbench.CommandLanguage;

/// <summary>A prompt for a value of a kind.</summary>
public abstract record ValuePrompt<T>(string Instruction) : Prompt(Instruction)
{
    /// <summary>Reads what was typed (never empty).</summary>
    /// <param name="lastPoint">What <c>@</c> is relative to, drawing units.</param>
    /// <returns>The value, or a sentence that says what is wanted.</returns>
    public abstract Reading<T> Read(string typed, Core.Geometry.Point2D lastPoint);
}
