using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands;

/// <summary>"Select objects:" as in AutoCAD, verb-noun or noun-verb. Coordinates are drawing units.</summary>
internal static class ObjectSelection
{
    /// <summary>Assumed height in pixels of a missing canvas that shows the drawing, or the view if that is smaller: the pick radius is then one percent of it
    /// at the initial PICKBOX.</summary>
    private const double ReachWithoutCanvas = 500.0;

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Window", "Crossing", "ALL", "Last", "Previous", "Handle", "LAyer", "Remove", "Add", "Undo");

    /// <summary>The previously selected objects, otherwise prompts for a selection.</summary>
    /// <param name="takesTexts">False for a command of curves: texts are removed from the selection, which is reported.</param>
    /// <exception cref="CommandException">No drawing is open, or nothing was selected.</exception>
    public static async Task<IReadOnlyList<int>> GetAsync(CommandContext context, bool takesTexts = false)
    {
        _ = context.Drawing;
        var before = context.Document.Current.Selection;
        if (before.Count == 0) return await PickAsync(context, takesTexts).ConfigureAwait(false);
        context.WriteMessage(Wording.Get("ObjectSelection.Found", before.Count));
        return takesTexts ? before : SomeCurves(context, before);
    }

    /// <summary>The same for commands that change or erase objects: without those on locked layers.</summary>
    /// <exception cref="CommandException">No drawing is open, nothing was selected, or all objects are locked.</exception>
    public static async Task<IReadOnlyList<int>> GetForEditAsync(CommandContext context, bool takesTexts = false) => Unlocked(context, await GetAsync(context, takesTexts).ConfigureAwait(false));

    /// <summary>The curves of some objects; reports how many texts are left out.</summary>
    public static IReadOnlyList<int> CurvesOf(CommandContext context, IReadOnlyList<int> objects)
    {
        var curves = context.Drawing.Entities.Count;
        var texts = objects.Count(index => index >= curves);
        if (texts == 0) return objects;
        context.WriteMessage(Wording.Get("ObjectSelection.TextsLeftOut", CountText.Format(texts, "Text")));
        return [.. objects.Where(index => index < curves)];
    }

    /// <summary>The editable ones of some objects; reports how many are on locked layers.</summary>
    /// <exception cref="CommandException">All of them are.</exception>
    public static IReadOnlyList<int> Unlocked(CommandContext context, IReadOnlyList<int> objects)
    {
        var free = WithoutLocked(context, objects);
        return free.Count > 0 || objects.Count == 0 ? free : throw new CommandException(CommandFailure.Refused, Wording.Get("ObjectSelection.AllLocked"));
    }

    /// <summary>The same, but an empty result is allowed.</summary>
    public static IReadOnlyList<int> WithoutLocked(CommandContext context, IReadOnlyList<int> objects)
    {
        if (!context.Drawing.Layers.Any(layer => layer.Locked)) return objects;
        var drawing = ShownDrawing.Of(context.Drawing);
        IReadOnlyList<int> free = [.. objects.Where(entity => !drawing.Layers[drawing.Entities[entity].Layer].Locked)];
        if (free.Count < objects.Count) context.WriteMessage(Wording.Get("ObjectSelection.Locked", objects.Count - free.Count));
        return free;
    }

    /// <summary>Prompts for objects until Enter.</summary>
    /// <exception cref="CommandException">No drawing is open, or nothing was selected.</exception>
    public static async Task<IReadOnlyList<int>> PickAsync(CommandContext context, bool takesTexts = false)
    {
        var picked = await PickObjectsAsync(context, Wording.Get("ObjectSelection.SelectObjects")).ConfigureAwait(false);
        if (picked.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("ObjectSelection.NothingSelected"));
        return takesTexts ? picked : SomeCurves(context, picked);
    }

    /// <summary>Curves, with another instruction; empty when none was selected.</summary>
    /// <exception cref="CommandException">No drawing is open.</exception>
    public static async Task<IReadOnlyList<int>> PickAsync(CommandContext context, string instruction) => CurvesOf(context, await PickObjectsAsync(context, instruction).ConfigureAwait(false));

    private static IReadOnlyList<int> SomeCurves(CommandContext context, IReadOnlyList<int> objects) =>
        CurvesOf(context, objects) is { Count: > 0 } curves ? curves : throw new CommandException(CommandFailure.Usage, Wording.Get("ObjectSelection.OnlyTexts"));

    private static async Task<IReadOnlyList<int>> PickObjectsAsync(CommandContext context, string instruction)
    {
        var drawing = ShownDrawing.Of(context.Drawing);
        var picking = new PickState();
        context.HighlightPicked(picking.Selected);
        while (await context.AskAsync(Prompt(instruction, picking.Adding)).ConfigureAwait(false) is var answer and not Answer<Point2D>.EndOfList)
        {
            switch (answer)
            {
                case Answer<Point2D>.SelectedOption { Option: "Remove" }: picking.Adding = false; break;
                case Answer<Point2D>.SelectedOption { Option: "Add" }: picking.Adding = true; break;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }: picking.Undo(); break;
                case Answer<Point2D>.SelectedOption { Option: var option }: context.WriteMessage(picking.Add(await ByOptionAsync(context, drawing, option).ConfigureAwait(false))); break;
                case Answer<Point2D>.Value { Result: var point }: context.WriteMessage(picking.Add(await ByPointAsync(context, drawing, point).ConfigureAwait(false))); break;
            }

            context.HighlightPicked(picking.Selected);
        }

        return picking.Selected;
    }

    private static PointPrompt Prompt(string instruction, bool adding) => new(adding ? instruction : Wording.Get("ObjectSelection.RemoveObjects"))
    {
        Options = s_options, EnterEnds = true, Purpose = PointPurpose.Object, IsDeselecting = !adding,
    };

    /// <summary>Prompts for one object until one is found at the picked point, and highlights it.</summary>
    /// <returns>Its index in the drawing's entities, and the point, drawing units.</returns>
    public static async Task<(int Entity, Point2D At)> PickOneAsync(CommandContext context, string instruction)
    {
        int? found = null;
        var prompt = new PointPrompt(instruction) { Purpose = PointPurpose.Object, Validate = at => (found = EntityAt(context, at)) is null ? Wording.Get("Reshape.NoObject") : null };
        var place = await context.ValueAsync(prompt).ConfigureAwait(false);
        context.HighlightPicked([found!.Value]);
        return (found.Value, place);
    }

    /// <summary>The visible curve under a point; null if there is none.</summary>
    public static int? EntityAt(CommandContext context, Point2D point) => DrawingPick.Nearest(context.Drawing, point, PickRadius(context));

    /// <summary>Pick radius, drawing units: half the side of the pickbox (PICKBOX) as shown on the canvas.</summary>
    public static double PickRadius(CommandContext context)
    {
        var (pickbox, view) = (context.Settings.Current.Variable("PICKBOX"), context.View.Current);
        if (view.CanvasHeight is { } pixels) return pickbox * view.Height / pixels;
        var box = DrawingPick.BoundsOf(context.Drawing, DrawingPick.Visible(context.Drawing));
        return pickbox / ReachWithoutCanvas * Math.Min(Math.Max(box.Width, box.Height), Math.Max(view.Window.Width, view.Window.Height));
    }

    private static async Task<IReadOnlyList<int>> ByOptionAsync(CommandContext context, Drawing drawing, string option) => option switch
    {
        "Window" => [.. DrawingPick.Inside(drawing, await BoxAsync(context).ConfigureAwait(false))],
        "Crossing" => [.. DrawingPick.Touching(drawing, await BoxAsync(context).ConfigureAwait(false))],
        "ALL" => [.. DrawingPick.Visible(drawing)],
        "Last" => Newest(drawing, context.Drawing.Entities.Count),
        "Previous" => context.Document.Current.Previous,
        "Handle" => ByHandle(drawing, await context.ValueAsync(new TextPrompt(Wording.Get("Common.EnterHandle"))).ConfigureAwait(false)),
        _ => ByLayer(drawing, await context.ValueAsync(new TextPrompt(Wording.Get("ObjectSelection.EnterLayerName"))).ConfigureAwait(false)),
    };

    /// <summary>The visible object that was drawn last: of the last curve and the last text that with the higher handle.</summary>
    private static IReadOnlyList<int> Newest(Drawing shown, int curves)
    {
        var visible = DrawingPick.Visible(shown).ToList();
        int[] last = [.. visible.Where(entity => entity < curves).TakeLast(1), .. visible.Where(entity => entity >= curves).TakeLast(1)];
        return last.Length < 2 || shown.Entities[last[1]].Handle > shown.Entities[last[0]].Handle ? [.. last.TakeLast(1)] : [last[0]];
    }

    /// <summary>On an object: that object. On empty space: a box, a window to the right, a crossing to the left.</summary>
    private static async Task<IReadOnlyList<int>> ByPointAsync(CommandContext context, Drawing drawing, Point2D point)
    {
        if (DrawingPick.Nearest(drawing, point, PickRadius(context)) is { } entity) return [entity];
        var corner = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = point }).ConfigureAwait(false);
        var box = Bounds2D.FromCorners(point, corner);
        return [.. corner.X >= point.X ? DrawingPick.Inside(drawing, box) : DrawingPick.Touching(drawing, box)];
    }

    private static async Task<Bounds2D> BoxAsync(CommandContext context)
    {
        var first = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyFirstCorner")) { Purpose = PointPurpose.Corner }).ConfigureAwait(false);
        return Bounds2D.FromCorners(first, await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = first }).ConfigureAwait(false));
    }

    private static IReadOnlyList<int> ByHandle(Drawing drawing, string handle) => [.. DrawingPick.Visible(drawing).Where(entity => IsHandle(drawing, entity, handle))];

    private static bool IsHandle(Drawing drawing, int entity, string handle) => string.Equals(drawing.SourceOf(entity).Handle, handle.TrimStart('0'), StringComparison.OrdinalIgnoreCase);

    private static IReadOnlyList<int> ByLayer(Drawing drawing, string name) =>
        [.. DrawingPick.Visible(drawing).Where(entity => drawing.Layers[drawing.Entities[entity].Layer].Name.Equals(name, StringComparison.OrdinalIgnoreCase))];

    /// <summary>The objects picked so far.</summary>
    private sealed class PickState
    {
        private readonly Stack<IReadOnlyList<int>> _before = new();

        public bool Adding { get; set; } = true;

        public IReadOnlyList<int> Selected { get; private set; } = [];

        /// <returns>AutoCAD's message: number found, number of duplicates, total.</returns>
        public string Add(IReadOnlyList<int> found)
        {
            _before.Push(Selected);
            var known = Selected.ToHashSet();
            var again = found.Count(known.Contains);
            var hit = found.ToHashSet();
            Selected = Adding ? [.. Selected, .. found.Where(entity => !known.Contains(entity))] : [.. Selected.Where(entity => !hit.Contains(entity))];
            if (!Adding) return Wording.Get("ObjectSelection.FoundRemoved", found.Count, again, Selected.Count);
            return again > 0 ? Wording.Get("ObjectSelection.FoundDuplicate", found.Count, again, Selected.Count) : Wording.Get("ObjectSelection.FoundTotal", found.Count, Selected.Count);
        }

        public void Undo() => Selected = _before.TryPop(out var earlier) ? earlier : Selected;
    }
}
