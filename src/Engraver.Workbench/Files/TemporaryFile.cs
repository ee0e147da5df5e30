namespace Engraver.Workbench.Files;

/// <summary>A file that is being written beside the place it is for. It is gone when it is disposed of or when the process ends, whatever comes first; only a killed process leaves it.</summary>
/// <remarks>A program that is stopped ends while a result may be half written on another thread; the end of the process is then the only one who can clear up.</remarks>
internal sealed class TemporaryFile : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string _target;
    private readonly string _path;
    private bool _over;

    /// <summary>Nothing is made yet.</summary>
    public TemporaryFile(string target)
    {
        _target = target;
        _path = $"{target}.{Environment.ProcessId}.tmp";
        AppDomain.CurrentDomain.ProcessExit += OnProcessExit;
    }

    /// <exception cref="IOException">The place cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The place may not be written.</exception>
    /// <exception cref="OperationCanceledException">The process ends.</exception>
    public FileStream Create()
    {
        lock (_guard)
        {
            if (_over) throw new OperationCanceledException();
            return new FileStream(_path, FileMode.Create, FileAccess.Write, FileShare.Delete);
        }
    }

    /// <summary>What was written takes the place of what stood there.</summary>
    /// <exception cref="IOException">The place cannot be written, or the process ends.</exception>
    public void TakePlace() => File.Move(_path, _target, overwrite: true);

    public void Dispose()
    {
        AppDomain.CurrentDomain.ProcessExit -= OnProcessExit;
        End();
    }

    /// <summary>From now on there is no such file, and none is made.</summary>
    internal void End()
    {
        lock (_guard)
        {
            _over = true;
            File.Delete(_path);
        }
    }

    private void OnProcessExit(object? sender, EventArgs e)
    {
        try
        {
            End();
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            // The folder is gone or no longer ours: nobody is left who could be told.
        }
    }
}
