using System.Text;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>What a command asks for: instruction, options, default. Shown as <c>Instruction or [Option/oPtion] &lt;default&gt;:</c>
/// (hmi-conventions.md section 4).</summary>
/// <param name="Instruction">What to do, without a colon.</param>
public abstract record Prompt(string Instruction)
{
    /// <summary>What may be typed instead of a value.</summary>
    public IReadOnlyList<Keyword> Options { get; init; } = [];

    /// <summary>What Enter alone means, as it is shown; null when there is no default.</summary>
    public string? Default { get; init; }

    /// <summary>True when Enter alone is an answer of its own (it ends a list).</summary>
    public bool EnterEnds { get; init; }

    /// <summary>True when spaces belong to the answer (a file name): a command window then takes Enter alone as the end.</summary>
    public virtual bool TakesSpaces => false;

    /// <summary>The place of the drawing that is an answer (a click on the canvas enters its coordinates); null when none is.</summary>
    public virtual PointAim? Aim => null;

    /// <summary>The files that fit, where the name of one is asked for; null where none is.</summary>
    public virtual FileWanted? File => null;

    /// <summary>True where Yes means that a file of which the name was given is replaced: who was asked before need not be asked again.</summary>
    public bool Replaces { get; init; }

    /// <summary>What Enter alone would lead to, wherever the cursor is, so that it can be seen before; null when there is nothing to be seen.</summary>
    public GhostOf? Preview { get; init; }

    /// <summary>True when nothing but an option is an answer.</summary>
    public virtual bool OnlyOptions => false;

    /// <summary>The prompt as it stands in the command window, its default with as many decimals as at the first start.</summary>
    public string Text => TextIn(Figures.Usual);

    /// <summary>The prompt as it stands in the command window.</summary>
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

    /// <summary>Enter alone where that ends a list.</summary>
    public sealed record Ended : Answer<T>;
}

/// <summary>The result of reading a typed value.</summary>
public abstract record Reading<T>
{
    private Reading()
    {
    }

    public sealed record Value(T Of) : Reading<T>;

    /// <param name="Sentence">What is wanted instead.</param>
    public sealed record Wrong(string Sentence) : Reading<T>;
}

/// <summary>A prompt for a value of a kind.</summary>
public abstract record ValuePrompt<T>(string Instruction) : Prompt(Instruction)
{
    /// <summary>Says why a value is no answer, so that it is asked for once more and nothing answered before is lost; null where it is one. Without this
    /// every value is an answer.</summary>
    public Func<T, string?>? Refusal { get; init; }

    /// <summary>Reads what was typed (never empty).</summary>
    /// <param name="lastPoint">What <c>@</c> is relative to, drawing units.</param>
    /// <returns>The value, or a sentence that says what is wanted.</returns>
    public abstract Reading<T> Read(string typed, Core.Geometry.Point2D lastPoint);
}
