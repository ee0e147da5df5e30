using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Core;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Trajectories;

/// <summary>A trajectory with its figures; editing a field runs SACEEDITTRAJECTORY, so that it can be undone.</summary>
/// <param name="refused">Called when a value was refused, so that the field is reset.</param>
public sealed class TrajectoryRow(DocumentTrajectory one, int index, int count, DesktopModel desk, Action refused) : ObservableObject
{
    /// <summary>The last edit: Enter accepts a value, and so does the field when it loses the focus, which it does when the table is recreated. The second
    /// time must not be a second step.</summary>
    private (string What, string Value)? _lastEdit;

    public string Name
    {
        get => one.Name;
        set => Edit("Name", value, one.Name);
    }

    public string Points => one.Curve.Points.ToString(CultureInfo.InvariantCulture);

    /// <summary>Proven bound, millimetres, never rounded down.</summary>
    public string Bound => DisplayPrecision.FormatErrorBound(one.Curve.VerifiedBound);

    /// <summary>True if the proven error exceeds the requested one, which equal steps may cause.</summary>
    public bool ExceedsTolerance => one.Curve.VerifiedBound > one.MaxErrorMm;

    /// <summary>Its objects have been edited since it was created.</summary>
    public bool IsStale { get; init; }

    public string Length => one.Curve.Length.ToString("0.###", CultureInfo.InvariantCulture);

    /// <summary>Largest ratio of neighbouring steps.</summary>
    public string Ratio => one.Curve.SpacingRatio.ToString("0.00", CultureInfo.InvariantCulture);

    /// <summary>Requested, millimetres.</summary>
    public string Error
    {
        get => NumberText.Rounded(one.MaxErrorMm, 6);
        set => Edit("Error", value, NumberText.Rounded(one.MaxErrorMm, 6));
    }

    public string Z
    {
        get => NumberText.Rounded(one.Curve.Z, 6);
        set => Edit("Z", value, NumberText.Rounded(one.Curve.Z, 6));
    }

    public bool CanMoveUp => index > 0;

    public bool CanMoveDown => index < count - 1;

    /// <summary>A helix is not recreated.</summary>
    public bool CanChangeError => !one.IsHelix;

    public RelayCommand MoveUp { get; } = new(() => _ = desk.Queue.RunAsync("SACEEDITTRAJECTORY", one.Name, "Up"));

    public RelayCommand MoveDown { get; } = new(() => _ = desk.Queue.RunAsync("SACEEDITTRAJECTORY", one.Name, "DOwn"));

    public RelayCommand Delete { get; } = new(() => _ = desk.Queue.RunAsync("SACEEDITTRAJECTORY", one.Name, "Delete"));

    /// <summary>Completes when the last edit has been accepted or refused.</summary>
    public Task Edited { get; private set; } = Task.CompletedTask;

    private void Edit(string what, string value, string now)
    {
        if (value.Trim() is not { Length: > 0 } typed) refused();
        else if (typed != now && _lastEdit != (what, typed)) Edited = EditAsync(what, typed);
    }

    private async Task EditAsync(string what, string value)
    {
        _lastEdit = (what, value);
        if (await desk.Queue.RunAsync("SACEEDITTRAJECTORY", one.Name, what, value) is not InputResult.Done) refused();
    }
}
