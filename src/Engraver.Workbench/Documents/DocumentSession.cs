using Engraver.Core.Drawings;
using Engraver.Workbench.Files;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>The open drawing with its edits, settings and undo history. One of the two mutable objects (the other is the machine session); the states are
/// immutable.</summary>
/// <remarks>A selection is not a step: it belongs to the current state. Steps come from one thread at a time; a selection may come from another
/// thread.</remarks>
public sealed class DocumentSession
{
    private readonly Lock _guard = new();
    private readonly Stack<Step> _undo = new();
    private readonly Stack<Step> _redo = new();
    private readonly Dictionary<string, string> _sidecars = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _saved = new(StringComparer.Ordinal);
    private readonly Dictionary<string, IReadOnlyDictionary<string, IReadOnlyList<string>>> _handles = new(StringComparer.Ordinal);
    private Drawing? _savedEdition;
    private Sidecar _savedSidecar = Sidecar.Empty;
    private int _newDrawings;

    /// <summary>Raised after the current state has changed.</summary>
    public event EventHandler? Changed;

    public DocumentState Current { get; private set; } = DocumentState.Nothing;

    /// <summary>True if the drawing or its sidecar has unsaved changes.</summary>
    public bool IsEdited => IsDrawingEdited || (Current.Edition is not null && !Current.Sidecar.IsSavedIn(_savedSidecar));

    /// <summary>True if the drawing itself has unsaved changes.</summary>
    public bool IsDrawingEdited => Current.Edition is { } edition && !ReferenceEquals(edition, _savedEdition);

    /// <summary>Names of the steps that can be undone, the last one first.</summary>
    public IEnumerable<string> UndoNames => _undo.Select(step => step.Name);

    /// <summary>Names of the steps that can be redone, the next one first.</summary>
    public IEnumerable<string> RedoNames => _redo.Select(step => step.Name);

    /// <summary>Commits a step and clears the redo history.</summary>
    /// <param name="name">The command of the step.</param>
    public void Commit(string name, DocumentState next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (next == Current) return;
            _undo.Push(new Step(name, Current));
            _redo.Clear();
            Current = next;
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Joins the last step to the one before it, so that one undo reverts both: a continued command is one step.</summary>
    public void JoinLastSteps()
    {
        if (_undo.Count > 1) _undo.Pop();
    }

    /// <summary>The drawing that was read, sharing equal columns with the drawings of this session's history to save memory.</summary>
    public Drawing ShareColumns(Drawing read)
    {
        ArgumentNullException.ThrowIfNull(read);
        foreach (var kept in _undo.Select(step => step.State.Edition).Prepend(Current.Edition).OfType<Drawing>().Distinct(ReferenceEqualityComparer.Instance).Cast<Drawing>())
        {
            if (read.SharingColumnsOf(kept) is var shared && ReferenceEquals(shared.Parts, kept.Parts)) return shared;
        }

        return read;
    }

    /// <summary>Replaces the current state within the last step: undo reverts both.</summary>
    public void Amend(DocumentState next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (next == Current) return;
            Current = next;
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Path of the drawing's file: the one written last, otherwise the opened one; null if no drawing is open.</summary>
    public string? FilePath => Current.Drawing is { FileName: var opened } ? _saved.GetValueOrDefault(opened, opened) : null;

    /// <summary>True if the drawing was opened from or saved to a file.</summary>
    public bool HasFile => Current.Drawing is { } drawing && (!drawing.IsNew || _saved.ContainsKey(drawing.FileName));

    /// <summary>The number of the next new drawing; 1 is the first of the session.</summary>
    public int NextDrawingNumber() => ++_newDrawings;

    /// <summary>Marks the current drawing and sidecar as unchanged since opening; a new drawing has nothing to save.</summary>
    public void MarkOpened()
    {
        if (Current.Drawing is { FileName: var opened })
        {
            _saved.Remove(opened);
            _handles.Remove(Path.GetFullPath(opened));
        }

        (_savedEdition, _savedSidecar) = (Current.Edition, Current.Sidecar);
    }

    /// <summary>Marks the placement of the drawing as part of its coordinates, which have been written.</summary>
    public void MarkPlacementSaved()
    {
        lock (_guard) Current = Current.WithPlacementSaved();
    }

    /// <summary>Marks the current drawing and sidecar as saved.</summary>
    /// <param name="path">Path of the drawing, from now on its file unless it is a stream.</param>
    public void MarkSaved(string path)
    {
        if (Current.Drawing is { FileName: var opened } drawing && !FileKind.IsStream(path))
        {
            _saved[opened] = path;
            if (drawing.IsNew) Current = Current with { Drawing = drawing with { FileName = path, IsNew = false } };
        }

        (_savedEdition, _savedSidecar) = (Current.Edition, Current.Sidecar);
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>The text of a sidecar file as last read or written by this session; null if neither.</summary>
    /// <param name="path">Path of the sidecar.</param>
    public string? KnownSidecar(string path) => _sidecars.GetValueOrDefault(Path.GetFullPath(path));

    /// <summary>Maps each handle of the drawing to the handles of its entities in a file written by this session; empty if they are equal, as in the opened
    /// file.</summary>
    /// <param name="path">Path of the drawing's file.</param>
    public IReadOnlyDictionary<string, IReadOnlyList<string>> HandlesIn(string path) => _handles.GetValueOrDefault(Path.GetFullPath(path)) ?? new Dictionary<string, IReadOnlyList<string>>();

    /// <summary>Stores the handles of the drawing's entities in a file.</summary>
    public void MarkHandles(string path, IReadOnlyDictionary<string, IReadOnlyList<string>> handles) => _handles[Path.GetFullPath(path)] = handles;

    /// <summary>Stores the current text of a sidecar file.</summary>
    public void MarkSidecar(string path, string text) => _sidecars[Path.GetFullPath(path)] = text;

    /// <summary>Sets the selection, without a step.</summary>
    public void Select(IReadOnlyList<int> selection, IReadOnlyList<int> previous)
    {
        lock (_guard) Current = Current with { Selection = selection, Previous = previous };
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Changes the selection of a drawing, unless another one has been opened.</summary>
    /// <param name="next">Returns the new selection for the current state.</param>
    public void SelectIn(Drawing drawing, Func<DocumentState, IReadOnlyList<int>> next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (!ReferenceEquals(Current.Drawing, drawing)) return;
            Current = Current with { Selection = next(Current) };
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Goes back to the state before the last step. Undo does not close an open drawing: opening the first drawing cannot be undone, and a drawing
    /// opened after closing another is replaced by that one.</summary>
    /// <returns>The name of the step, null if there is none.</returns>
    public string? Undo()
    {
        var open = Current.Drawing is not null;
        if (open && !_undo.Any(step => step.State.Drawing is not null)) return null;
        var name = Swap(_undo, _redo);
        while (open && Current.Drawing is null) Swap(_undo, _redo);
        return name;
    }

    /// <summary>Repeats the step that was undone last.</summary>
    /// <returns>The name of the step, null if there is none.</returns>
    public string? Redo() => Swap(_redo, _undo);

    private string? Swap(Stack<Step> from, Stack<Step> to)
    {
        string name;
        lock (_guard)
        {
            if (!from.TryPop(out var step)) return null;
            to.Push(step with { State = Current });
            (name, Current) = (step.Name, step.State);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return name;
    }

    private readonly record struct Step(string Name, DocumentState State);
}
