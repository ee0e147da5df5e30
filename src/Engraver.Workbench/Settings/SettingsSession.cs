using Engraver.Core.Languages;

namespace Engraver.Workbench.Settings;

/// <summary>The settings of the desktop and the file that keeps them. Without a file they live as long as the session.</summary>
public sealed class SettingsSession
{
    private readonly Lock _guard = new();
    private readonly string? _path;

    /// <param name="path">Null: nothing is read or kept.</param>
    public SettingsSession(string? path, TimeProvider time)
    {
        (Current, Finding) = path is null ? (DesktopSettings.Default, null) : SettingsFile.Load(path, time);
        _path = Finding is not null && File.Exists(path) ? null : path; // a file that could be neither read nor set aside is not overwritten
    }

    /// <summary>Raised after a setting has changed, on the thread of the change.</summary>
    public event EventHandler? Changed;

    public DesktopSettings Current { get; private set; }

    /// <summary>A sentence for the operator when the file could not be read or written; null while all is well.</summary>
    public string? Finding { get; private set; }

    /// <summary>Changes the settings and keeps them. When the file cannot be written, <see cref="Finding"/> says so and the change holds for the
    /// session.</summary>
    public void Change(Func<DesktopSettings, DesktopSettings> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            var next = change(Current);
            if (next == Current) return;
            Current = next;
            Save();
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    private void Save()
    {
        if (_path is null) return;
        try
        {
            SettingsFile.Save(_path, Current);
            Finding = null;
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            Finding = Wording.Get("SettingsSession.NotSaved", _path, SystemErrorText.FromException(stuck));
        }
    }
}
