using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Text;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>A text that a command is about to add: its form, preview and addition to the drawing.</summary>
internal sealed record TextDraft
{
    /// <summary>Name of the last height (TEXTSIZE in AutoCAD).</summary>
    private const string HeightName = "TEXTSIZE";

    private const double MetricHeight = 2.5;
    private const double InchHeight = 0.2;

    public TextStyle Style { get; init; } = new("Standard");

    public TextJustification Justification { get; init; } = TextJustification.Left;

    /// <summary>Start, or the point of the justification, drawing units.</summary>
    public Point2D At { get; init; }

    /// <summary>The second point of Align and Fit.</summary>
    public Point2D? To { get; init; }

    public double Height { get; init; }

    public Angle Rotation { get; init; }

    /// <summary>The form with the current style and the last height.</summary>
    public static TextDraft Current(CommandContext context)
    {
        var style = CurrentTextStyle.Of(context.Document.Current);
        return new TextDraft { Style = style, Height = style.FixedHeight > 0.0 ? style.FixedHeight : LastHeight(context) };
    }

    /// <summary>The default of the height.</summary>
    public static double LastHeight(CommandContext context)
    {
        if (context.LastValue(HeightName) is { } last && CommandLanguage.NumberPrompt.TryParse(last, out var height)) return height;
        return context.Drawing.Scale.ToMillimetres(1.0) > 10.0 ? InchHeight : MetricHeight;
    }

    public static void RememberHeight(CommandContext context, double height) => context.Remember(HeightName, CommandLanguage.NumberPrompt.Format(height));

    /// <summary>A line of text in this form, with its typed string.</summary>
    public PlacedText Line(string typed, int layer)
    {
        var place = new Vector3D(At.X, At.Y, 0.0);
        return Placed("TEXT", layer, new WrittenText
        {
            Raw = TypedText.ToLine(typed),
            Insertion = place,
            Second = To is { } to ? new Vector3D(to.X, to.Y, 0.0) : Justification.IsLeft ? null : place,
            Height = Height,
            WidthFactor = Style.WidthFactor,
            Oblique = Style.Oblique,
            Rotation = To is { } end && end != At ? (end - At).Direction.Positive() : Rotation,
            Generation = Style.Generation,
            Horizontal = Justification.Horizontal,
            Vertical = Justification.Vertical,
            Extrusion = new Vector3D(0.0, 0.0, 1.0),
        });
    }

    /// <summary>Lines as an MTEXT in this form.</summary>
    public PlacedText Paragraphs(IEnumerable<string> lines, int layer, WrittenParagraphs form) => Placed("MTEXT", layer, new WrittenText
    {
        Raw = TypedText.ToParagraphs(lines),
        Insertion = new Vector3D(At.X, At.Y, 0.0),
        Height = Height,
        Rotation = Rotation,
        Extrusion = new Vector3D(0.0, 0.0, 1.0),
        Paragraphs = form,
    });

    /// <summary>The letters of a text as they would be cut.</summary>
    public static IReadOnlyList<Segment> Preview(Drawing drawing, PlacedText text) => PreviewOf(drawing, [text]);

    /// <summary>The letters of some texts as they would be cut.</summary>
    public static IReadOnlyList<Segment> PreviewOf(Drawing drawing, IReadOnlyList<PlacedText> texts)
    {
        var letters = ShownDrawing.LettersOf(drawing, texts);
        return [.. Enumerable.Range(0, letters.Entities.Count).SelectMany(entity => DrawingPick.Segments(letters, entity))];
    }

    /// <summary>The state with the texts added behind the others.</summary>
    /// <exception cref="CommandException">A text is outside the range of a drawing.</exception>
    public DocumentState AddTo(DocumentState state, Func<int, PlacedText> create)
    {
        var (drawing, layer) = CurrentLayer.FindOrAdd(state);
        var text = create(layer);
        if (!TextSummary.IsInRange(text)) throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        var styles = drawing.Styles.Any(style => style.Name.Equals(Style.Name, StringComparison.OrdinalIgnoreCase)) ? drawing.Styles : [.. drawing.Styles, Style];
        return state with { Drawing = drawing with { Styles = styles, Texts = [.. drawing.Texts, text with { Handle = drawing.HighestHandle() + 1 }] }, Selection = [] };
    }

    private PlacedText Placed(string type, int layer, WrittenText written) => TextSummary.Derived(new PlacedText
    {
        Type = type,
        Written = written,
        Content = "",
        Position = default,
        Height = 0.0,
        Rotation = default,
        Style = Style.Name,
        Font = Style.FontFile,
        Layer = layer,
    });
}
