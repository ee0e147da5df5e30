using System.Collections.ObjectModel;
using Avalonia.Controls.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>The volumes that the managed file dialog lists: the root of the file system and those mounted under /media and /mnt.</summary>
internal sealed class MountedVolumes : IMountedVolumeInfoProvider
{
    public IDisposable Listen(ObservableCollection<MountedVolumeInfo> mountedDrives)
    {
        foreach (var drive in DriveInfo.GetDrives().Where(IsUserDrive))
        {
            mountedDrives.Add(new MountedVolumeInfo { VolumeLabel = drive.Name, VolumePath = drive.Name, VolumeSizeBytes = 0 });
        }

        return new NoSubscription();
    }

    private static bool IsUserDrive(DriveInfo drive) =>
        drive.Name == "/" || drive.Name.StartsWith("/media/", StringComparison.Ordinal) || drive.Name.StartsWith("/mnt/", StringComparison.Ordinal);

    private sealed class NoSubscription : IDisposable
    {
        public void Dispose()
        {
        }
    }
}
