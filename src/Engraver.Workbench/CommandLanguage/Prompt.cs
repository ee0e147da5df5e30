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
    public virtual bool AllowsSpaces => false;

    /// <summary>The requested point of the drawing (a click on the canvas enters its coordinates); null if no point is requested.</summary>
    public virtual PointRequest? PointRequest => null;

    /// <summary>The requested file; null if no file is requested.</summary>
    public virtual FileRequest? FileRequest => null;

    /// <summary>True if Yes replaces the named file: a dialog that has already asked need not ask again.</summary>
    public bool ConfirmsReplacing { get; init; }

    /// <summary>Preview of the result of Enter alone, independent of the cursor; null without a preview.</summary>
    public GhostFunction? Preview { get; init; }

    /// <summary>True when only an option is accepted.</summary>
    public virtual bool OnlyOptions => false;

    /// <summary>The prompt as shown in the command window, its default with the initial number of decimals.</summary>
    public string Text => TextIn(DisplayPrecision.Initial);

    /// <summary>The prompt as shown in the command window.</summary>
    public string TextIn(DisplayPrecision figures)
    {
        var text = new StringBuilder(Instruction);
        if (Options.Count > 0) text.Append(OnlyOptions ? " [" : Wording.Get("Prompt.Or")).AppendJoin('/', Options.Select(option => option.Shown)).Append(']');
        if (Default is { } standard) text.Append(" <").Append(Keyword.FormatDefault(Options, figures.FormatDefault(standard))).Append('>');
        return text.Append(':').ToString();
    }
}
