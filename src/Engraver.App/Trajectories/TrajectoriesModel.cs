using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Trajectories;

/// <summary>The trajectories of the document, each with its figures and what can be changed of it.</summary>
public sealed class TrajectoriesModel : Observable
{
    private readonly DesktopModel _desk;
    private TrajectoryList? _shown;

    public TrajectoriesModel(DesktopModel desk)
    {
        _desk = desk;
        Export = new Act(() => _ = desk.RunAsync("SACEEXPORTTRAJECTORIES"));
        DeleteAll = new Act(() => _ = desk.RunAsync("SACEDELETEALLTRAJECTORIES"));
        desk.Changed += Look;
        Look();
    }

    public IReadOnlyList<TrajectoryRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>How many, and how the next ones are made.</summary>
    public string Summary { get; private set; } = "";

    public Act Export { get; }

    public Act DeleteAll { get; }

    private void Look()
    {
        var list = _desk.Session.Document.Current.Sidecar.Trajectories;
        if (ReferenceEquals(list, _shown)) return;
        _shown = list;
        Rows = [.. list.All.Select((one, index) => new TrajectoryRow(one, index, list.All.Count, _desk, Anew))];
        Summary = Text.Get(list.Settings.DynamicDensity ? "Trajectories.Dynamic" : "Trajectories.Uniform", list.All.Sum(one => one.Curve.Points), list.Settings.DynamicDensity ? list.Settings.MaxErrorMm : list.Settings.SegmentLengthMm);
        Tell(null);
    }

    private void Anew()
    {
        _shown = null;
        Look();
    }
}
