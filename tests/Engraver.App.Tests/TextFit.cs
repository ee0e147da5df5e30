using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Controls.Primitives;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.VisualTree;

namespace Engraver.App.Tests;

/// <summary>Finds texts that are not completely visible: cut off at their own bounds, shortened with dots, or beyond an edge of a container.</summary>
/// <remarks>Text that is scrolled out of view in a list is not cut off. A text that is shortened with dots and has itself as its tip is shown completely by
/// the tip (names of files, layers, profiles). A control without any room was hidden by its panel (FittingRow) and is not cut off. Works in any language:
/// the texts are taken as shown.</remarks>
internal static class TextFit
{
    /// <summary>Shaped glyphs and rounded pixels may differ by this much, units of 1/96 inch.</summary>
    private const double Tolerance = 1.0;

    /// <summary>One line for each visible text under <paramref name="root"/> that is not shown completely; empty if all are.</summary>
    /// <param name="root">A window, or a part of one.</param>
    public static IReadOnlyList<string> CutOff(Visual root) =>
        [.. root.GetVisualDescendants().OfType<TextBlock>().Where(IsShown).Select(Complaint).OfType<string>().Distinct()];

    /// <summary>One line for each pair of texts under <paramref name="root"/> that overlap, and for each text that a button covers.</summary>
    public static IReadOnlyList<string> Overlapping(Visual root)
    {
        var texts = root.GetVisualDescendants().OfType<TextBlock>().Where(IsShown).Select(block => (Block: block, Box: BoxIn(root, block, DrawnIn(block)))).Where(text => !IsScrolledAway(text.Block)).ToList();
        var keys = root.GetVisualDescendants().OfType<Button>().Where(key => key.IsEffectivelyVisible && key.FindAncestorOfType<ScrollBar>() is null).Select(key => (Key: key, Box: BoxIn(root, key, new Rect(key.Bounds.Size)))).ToList();
        var crossed = texts.SelectMany((one, i) => texts.Skip(i + 1).Where(other => Cross(one.Box, other.Box)).Select(other => Say(one.Block, $"crosses '{WordsOf(other.Block)}'")));
        var covered = texts.SelectMany(text => keys.Where(key => !key.Key.IsVisualAncestorOf(text.Block) && Cross(text.Box, key.Box)).Select(key => Say(text.Block, $"is under the button {key.Key.Name}")));
        return [.. crossed.Concat(covered).Distinct()];
    }

    private static bool Cross(Rect one, Rect other) => one.Deflate(Tolerance).Intersects(other.Deflate(Tolerance));

    private static Rect BoxIn(Visual root, Visual control, Rect box) => box.TransformToAABB(control.TransformToVisual(root) ?? default);

    /// <summary>The bounds of the letters.</summary>
    private static Rect DrawnIn(TextBlock block)
    {
        var drawn = new Size(Math.Min(block.TextLayout.Width, block.Bounds.Width), Math.Min(block.TextLayout.Height, block.Bounds.Height));
        return new Rect(drawn).Translate(AlignedIn(block, drawn));
    }

    /// <summary>It is completely out of view.</summary>
    private static bool IsScrolledAway(TextBlock block) => block.GetVisualAncestors().OfType<ScrollContentPresenter>().Any(scroller => !new Rect(scroller.Bounds.Size).Contains(BoxIn(scroller, block, DrawnIn(block))));

    private static bool IsShown(TextBlock block) => block.IsEffectivelyVisible && block.Bounds.Size != default && WordsOf(block).Trim().Length > 0;

    private static string? Complaint(TextBlock block)
    {
        if (IsShownByTip(block)) return null;
        var needed = NeededBy(block);
        var room = block.Bounds.Size.Deflate(block.Padding);
        if (needed.Width > room.Width + Tolerance || needed.Height > room.Height + Tolerance)
            return Say(block, $"needs {needed.Width:0.#} x {needed.Height:0.#} and has {room.Width:0.#} x {room.Height:0.#}");
        if (block.MaxLines > 0 && LinesOf(block) is var lines && lines > block.MaxLines) return Say(block, $"needs {lines} lines and may have {block.MaxLines}");
        return EdgeThatCuts(block, new Rect(needed)) is { } edge ? Say(block, edge) : null;
    }

    private static string Say(TextBlock block, string what) => FormattableString.Invariant($"'{WordsOf(block)}' ({string.Join(" > ", block.GetVisualAncestors().OfType<Control>().Select(NameOf).Where(name => name.Length > 0).Take(3).Reverse().Append(block.Name ?? "TextBlock"))}) {what}");

    private static string NameOf(Control control) => control is UserControl ? control.GetType().Name : control.Name is { Length: > 0 } name && !name.StartsWith("PART_", StringComparison.Ordinal) ? name : "";

    /// <summary>True for a text that may be shortened with dots because its tip, or that of a container, contains it completely.</summary>
    private static bool IsShownByTip(TextBlock block) => block.TextTrimming != TextTrimming.None
        && block.GetSelfAndVisualAncestors().OfType<Control>().Any(control => ToolTip.GetTip(control) is string tip && tip.Contains(WordsOf(block), StringComparison.Ordinal));

    private static string WordsOf(TextBlock block)
    {
        var text = block.Text is { Length: > 0 } plain ? plain : block.Inlines?.Text ?? "";
        return block is AccessText ? text.Replace("_", "", StringComparison.Ordinal) : text;
    }

    /// <summary>The room that the complete text needs: unwrapped, or wrapped at its width, where a word may still be wider than that.</summary>
    private static Size NeededBy(TextBlock block)
    {
        var natural = Laid(block, WordsOf(block), double.PositiveInfinity);
        if (block.TextWrapping == TextWrapping.NoWrap) return new Size(natural.Width, natural.Height);
        var width = Math.Max(1, block.Bounds.Width - block.Padding.Left - block.Padding.Right);
        if (natural.Width <= width) return new Size(natural.Width, natural.Height);
        var widestWord = WordsOf(block).Split([' ', '\n', '-', '/', '\\'], StringSplitOptions.RemoveEmptyEntries).Max(word => Laid(block, word, double.PositiveInfinity).Width);
        return new Size(block.TextWrapping == TextWrapping.Wrap && IsOneWord(block) ? width : widestWord, Laid(block, WordsOf(block), width + Tolerance).Height);
    }

    private static int LinesOf(TextBlock block) => Laid(block, WordsOf(block), Math.Max(1, block.Bounds.Width - block.Padding.Left - block.Padding.Right) + Tolerance).TextLines.Count;

    /// <summary>A path or another text without a space can only be wrapped inside a word.</summary>
    private static bool IsOneWord(TextBlock block) => !WordsOf(block).Contains(' ', StringComparison.Ordinal);

    private static TextLayout Laid(TextBlock block, string text, double width) =>
        new(text, new Typeface(block.FontFamily, block.FontStyle, block.FontWeight, block.FontStretch), block.FontSize, null, textWrapping: double.IsInfinity(width) ? TextWrapping.NoWrap : block.TextWrapping, maxWidth: width,
            lineHeight: block.LineHeight, letterSpacing: block.LetterSpacing);

    /// <summary>Walks from the text up to the window. Above a scrolling container only what can be scrolled into view counts.</summary>
    private static string? EdgeThatCuts(TextBlock block, Rect text)
    {
        var box = text.Translate(AlignedIn(block, text.Size));
        for (Visual at = block; at.GetVisualParent() is { } parent; at = parent)
        {
            if (at.TransformToVisual(parent) is not { } matrix) return "is in no window";
            box = box.TransformToAABB(matrix);
            var room = new Rect(parent.Bounds.Size);
            if (parent is ScrollContentPresenter scroller) box = Scrolled(box, room, scroller);
            if (!parent.ClipToBounds && parent is not TopLevel) continue;
            if (!room.Inflate(Tolerance).Contains(box)) return FormattableString.Invariant($"is at {box} and its {parent.GetType().Name} {(parent as Control)?.Name} ends at {room}");
        }

        return null;
    }

    /// <summary>The start of the text in its block.</summary>
    private static Vector AlignedIn(TextBlock block, Size text)
    {
        var spare = Math.Max(0, block.Bounds.Width - block.Padding.Left - block.Padding.Right - text.Width);
        return new Vector(block.Padding.Left + (block.TextAlignment switch { TextAlignment.Right => spare, TextAlignment.Center => spare / 2, _ => 0 }), block.Padding.Top);
    }

    private static Rect Scrolled(Rect box, Rect room, ScrollContentPresenter scroller)
    {
        if (scroller.CanVerticallyScroll) box = new Rect(box.X, room.Y, box.Width, Math.Min(box.Height, room.Height));
        return scroller.CanHorizontallyScroll ? new Rect(room.X, box.Y, Math.Min(box.Width, room.Width), box.Height) : box;
    }
}
