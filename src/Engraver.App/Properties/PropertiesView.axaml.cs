using Avalonia.Controls;

namespace Engraver.App.Properties;

/// <summary>The palette of the selection.</summary>
public partial class PropertiesView : UserControl
{
    public PropertiesView() => InitializeComponent();
}
