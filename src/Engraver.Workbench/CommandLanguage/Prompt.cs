using System.Text;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>A question of a command: instruction, options, default. Shown as <c>Instruction or [Option/oPtion] &lt;default&gt;:</c> (hmi-conventions.md section
/// 4).</summary>
/// <param name="Instruction">What to do, without a colon.</param>
public abstract record Prompt(string Instruction)
{
    /// <summary>What may be typed instead of a value.</summary>
    public IReadOnlyList<Keyword> Options { get; init; } = [];

    /// <summary>The value of Enter alone, as displayed; null without a default.</summary>
    public string? Default { get; init; }

    /// <summary>True when Enter alone is an answer (it ends a list).</summary>
    public bool EnterEnds { get; init; }

    /// <summary>True when an answer may contain spaces (a file name): then only Enter ends it in a command window.</summary>
    public virtual bool TakesSpaces => false;

    /// <summary>The requested point of the drawing (a click on the canvas enters its coordinates); null if no point is requested.</summary>
    public virtual PointAim? Aim => null;

    /// <summary>The requested file; null if no file is requested.</summary>
    public virtual FileWanted? File => null;

    /// <summary>True if Yes replaces the named file: a dialog that has already asked need not ask again.</summary>
    public bool Replaces { get; init; }

    /// <summary>Preview of the result of Enter alone, independent of the cursor; null without a preview.</summary>
    public GhostOf? Preview { get; init; }

    /// <summary>True when only an option is accepted.</summary>
    public virtual bool OnlyOptions => false;

    /// <summary>The prompt as shown in the command window, its default with the initial number of decimals.</summary>
    public string Text => TextIn(Figures.Usual);

    /// <summary>The prompt as shown in the command window.</summary>
    public string TextIn(Figures figures)
    {
        var text = new StringBuilder(Instruction);
        if (Options.Count > 0) text.Append(OnlyOptions ? " [" : Wording.Get("Prompt.Or")).AppendJoin('/', Options.Select(option => option.Shown)).Append(']');
        if (Default is { } standard) text.Append(" <").Append(Keyword.ShowDefault(Options, figures.Default(standard))).Append('>');
        return text.Append(':').ToString();
    }
}

/// <summary>What the operator answered to a prompt.</summary>
public abstract record Answer<T>
{
    private Answer()
    {
    }

    public sealed record Value(T Of) : Answer<T>;

    /// <param name="Option">The option's name as the prompt spells it.</param>
    public sealed record Chosen(string Option) : Answer<T>;

    /// <summary>Enter alone, which ends a list.</summary>
    public sealed record Ended : Answer<T>;
}

/// <summary>The result of reading a typed value.</summary>
public abstract record Reading<T>
{
    private Reading()
    {
    }

    public sealed record Value(T Of) : Reading<T>;

    /// <param name="Sentence">States which input is expected.</param>
    public sealed record Wrong(string Sentence) : Reading<T>;
}

/// <summary>A prompt for a value of a type.</summary>
public abstract record ValuePrompt<T>(string Instruction) : Prompt(Instruction)
{
    /// <summary>Returns why a value is rejected, null if it is accepted. A rejected value is asked for again without losing earlier answers. Without this
    /// function every value is accepted.</summary>
    public Func<T, string?>? Refusal { get; init; }

    /// <summary>Reads what was typed (never empty).</summary>
    /// <param name="lastPoint">What <c>@</c> is relative to, drawing units.</param>
    /// <returns>The value, or a sentence that states which input is expected.</returns>
    public abstract Reading<T> Read(string typed, Core.Geometry.Point2D lastPoint);
}
